// Flights as test cases, for continuous integration.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "runtime/executive/scenario/run.hpp"

namespace rmpl::tools {

/// A scenario that was flown, and how long that took.
struct Flown {
  const automata::Scenario* scenario;
  runtime::ScenarioResult result;
  double seconds;
};

/// A suite, with a case for each expectation of each flight, in the order of the file; a flight that expects nothing is
/// one case. How long a flight took stands with its first case. What is undecided is an error.
std::string to_junit(const std::string& suite, const std::vector<Flown>& flights);

}  // namespace rmpl::tools
