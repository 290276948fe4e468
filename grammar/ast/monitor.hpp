// Monitors as written (grammar/mon.ebnf): how the numbers of a channel become values of an attribute.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "grammar/ast/token.hpp"

namespace rmpl::grammar {

/// `low below 280;`, `nominal 280 to 340;`, `high above 340;`
struct BandText {
  enum class Kind { below, between, above };
  Span span;
  Name value;
  Kind kind = Kind::between;
  Number limit;
  std::optional<Number> upper;  ///< of `between`
};

/// What a channel may say besides a number within limits.
using LiteralText = std::variant<String, Number>;

/// `open = "ON", 1;`
struct LiteralsText {
  Span span;
  Name value;
  std::vector<LiteralText> literals;
};

/// `hysteresis 2;`
struct HysteresisText {
  Span span;
  Number by;
};

/// `persist 3;`, in samples, or `persist 2 s;`
struct PersistText {
  Span span;
  Duration amount;  ///< without a unit: samples
};

/// `stale after 5 s;`
struct StaleText {
  Span span;
  Duration after;
};

using MonitorItem = std::variant<BandText, LiteralsText, HysteresisText, PersistText, StaleText>;

/// `channel "P1" - "P2" : filter.drop { … }`, `channel "P1" rate over 2 s : tank.trend { … }`
struct MonitorDefinition {
  Span span;
  String channel;
  std::optional<String> minus;
  std::optional<Duration> over;
  Name attribute;
  std::vector<MonitorItem> items;
};

/// A whole `.mon` file.
struct MonitorFile {
  std::vector<MonitorDefinition> monitors;
};

}  // namespace rmpl::grammar
