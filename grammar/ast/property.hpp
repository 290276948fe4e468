// Properties of a plant, and of a program that controls it, as written (grammar/props.ebnf).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "grammar/ast/constraint.hpp"
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

/// `expect violated;`
struct ExpectedVerdict {
  Span span;
  bool violated = false;
};

using PropertyItem =
    std::variant<NeverClaim, ReachClaim, ResponseClaim, EventuallyClaim, FinallyClaim, GeneralClaim, FaultsSetting,
                 TimeSetting, CommandsSetting, FromSetting, EntailedSetting, ExpectedVerdict>;

/// `property "name" { … }`
struct PropertyDefinition {
  Span span;
  String name;
  std::vector<PropertyItem> items;
};

/// A whole `.props` file. Settings that stand outside of properties are `defaults`; nothing else is among them.
struct PropertyFile {
  std::vector<PropertyItem> defaults;
  std::vector<PropertyDefinition> properties;
};

}  // namespace rmpl::grammar
