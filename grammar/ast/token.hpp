// The leaves of every tree: names, numbers, durations and strings, each with its place.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "grammar/source/span.hpp"

namespace rmpl::grammar {

/// An identifier as written, dots and dashes included: `prop.engine.temp` is one name. Also a value of a domain, and
/// then it may be `true` or `false`.
struct Name {
  Span span;
  std::string text;
};

/// A decimal number. `value` is finite: a number beyond the range of a double is reported by the parser.
struct Number {
  Span span;
  std::string text;  ///< as written, with its sign where the grammar allows one
  double value = 0;
};

/// A length of time as written. `number + unit` is what automata::parse_duration reads.
struct Duration {
  Span span;
  std::string number;     ///< the decimal; empty where `infinite`
  std::string unit;       ///< ns us ms s min mins h d w weeks, or empty: seconds
  bool infinite = false;  ///< `inf` or `∞`, only as an upper time bound
  [[nodiscard]] std::string text() const { return infinite ? "inf" : number + unit; }
};

/// A string literal; `text` is what stands between the quotes, with \" and \\ resolved.
struct String {
  Span span;
  std::string text;
};

}  // namespace rmpl::grammar
