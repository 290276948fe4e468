// Properties of a plant as written (grammar/props.ebnf).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "grammar/ast/constraint.hpp"
#include "grammar/ast/token.hpp"

namespace rmpl::grammar {

/// `never φ;`
struct NeverClaim {
  Span span;
  Constraint constraint;
};

/// `reach φ;`
struct ReachClaim {
  Span span;
  Constraint constraint;
};

/// `after φ within T ψ;`
struct ResponseClaim {
  Span span;
  Constraint after;
  Duration within;
  Constraint then;
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

using PropertyItem = std::variant<NeverClaim, ReachClaim, ResponseClaim, FaultsSetting, TimeSetting, CommandsSetting,
                                  FromSetting, EntailedSetting, ExpectedVerdict>;

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
