// Flights as test cases, for continuous integration.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tools/rmpl-run/flight.hpp"

namespace rmpl::tools {

/// A suite for each file, with a case for each expectation of each flight, in their order; a flight that expects
/// nothing is one case. How long a flight took stands with its first case. What is undecided is an error.
std::string to_junit(const std::vector<Task>& tasks, const std::vector<Flown>& flights);

}  // namespace rmpl::tools
