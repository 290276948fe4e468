// Properties of a plant, and of a program that controls it, as written (grammar/props.ebnf).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "grammar/ast/constraint.hpp"
#include "grammar/ast/requirement.hpp"
#include "grammar/ast/token.hpp"

namespace rmpl::grammar {

/// `never φ;`, `program never φ;`
struct NeverClaim {
  Span span;
  bool of_program = false;
  Constraint constraint;
};

/// `reach φ;`
struct ReachClaim {
  Span span;
  Constraint constraint;
};

/// `after φ within T ψ;`, `program after φ within T ψ;`
struct ResponseClaim {
  Span span;
  bool of_program = false;
  Constraint after;
  Duration within;
  Constraint then;
};

/// `program eventually φ within T;`
struct EventuallyClaim {
  Span span;
  Constraint constraint;
  Duration within;
};

/// `program finally φ;`
struct FinallyClaim {
  Span span;
  Constraint constraint;
};

/// `probability of φ within T at most 1e-5;`, `program probability of φ at least 0.9;`
struct ProbabilityClaim {
  Span span;
  bool of_program = false;
  Constraint constraint;
  std::optional<Duration> within;  ///< none: ever
  bool at_least = false;
  Number bound;
};

/// `never stuck;`, `program terminates;`, `program never no-plan;`: what is the same for every plant or program.
struct GeneralClaim {
  enum class Kind { stuck, goal_conflict, no_plan, endless_wait, termination, undone };
  Span span;
  bool of_program = false;
  Kind kind = Kind::stuck;
};

/// `faults 2;`
struct FaultsSetting {
  Span span;
  std::uint64_t count = 0;
};

/// `time dense;`, `time 0.5 s;`
struct TimeSetting {
  Span span;
  std::optional<Duration> period;  ///< none: dense
};

/// `commands any;`
struct CommandsSetting {
  enum class Freedom { none, one, any };
  Span span;
  Freedom freedom = Freedom::one;
};

/// `from engine = off, valve = open;`
struct FromSetting {
  Span span;
  std::vector<AssignmentText> modes;
};

/// `entailed;`
struct EntailedSetting {
  Span span;
};

/// `allow-stuck;`
struct AllowStuckSetting {
  Span span;
};

/// `severity catastrophic;`: of the failure that the property excludes (ECSS-Q-ST-30-02C).
struct SeveritySetting {
  enum class Severity { catastrophic, critical, major, minor };
  Span span;
  Severity severity = Severity::catastrophic;
};

/// `expect violated;`
struct ExpectedVerdict {
  Span span;
  bool violated = false;
};

using PropertyItem =
    std::variant<NeverClaim, ReachClaim, ResponseClaim, EventuallyClaim, FinallyClaim, ProbabilityClaim, GeneralClaim,
                 FaultsSetting, TimeSetting, CommandsSetting, FromSetting, EntailedSetting, AllowStuckSetting,
                 SeveritySetting, ExpectedVerdict, RequirementPart>;

/// `property "name" { … }`, `hazard "name" { … }` or, shorter, `hazard "name" never φ; severity catastrophic;`, where
/// `requirement "R";` may follow.
struct PropertyDefinition {
  Span span;
  bool hazard = false;  ///< what it claims never to be is harm
  bool braces = true;
  String name;
  std::vector<PropertyItem> items;
};

/// A whole `.props` file. Settings that stand outside of properties are `defaults`; nothing else is among them.
struct PropertyFile {
  std::vector<PropertyItem> defaults;
  std::vector<PropertyDefinition> properties;
};

}  // namespace rmpl::grammar
