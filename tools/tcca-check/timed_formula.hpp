// Formulas with a time, as options take them: `0.5 s x = y`, `x = y 0.5 s`, `x = y within 0.5 s`.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/time/time.hpp"

namespace rmpl::tools {

/// A formula as written, and a time where one stands with it.
struct TimedFormula {
  std::string formula;
  std::optional<automata::Ticks> time;
};

/// `T φ`, `φ T` or `φ` alone, and each with `within` before T. Throws BadValue where `within` stands and no
/// time follows it.
TimedFormula timed_formula(const std::string& text);

/// What is owed after what: `φ within T ψ`, or `φ within ψ T`.
struct TimedResponse {
  std::string asks;
  TimedFormula then;
};
/// The response is empty where no `within` stands in the text: it may be said elsewhere. Throws BadValue
/// where one stands without a time and a formula behind it.
TimedResponse timed_response(const std::string& text);

/// The arguments of a command line. A time and a formula that follow `--within` as two words become one, so that what
/// takes the one takes the other.
std::vector<std::string> with_joined_times(int count, const char* const* arguments);

}  // namespace rmpl::tools
