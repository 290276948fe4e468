// tcca-check reachability, safety, response.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/command_line.hpp"
#include "verifier/property/property.hpp"

namespace verifier {

/// Checks one property of a plant and prints the answer. Throws InputError and Rejected.
Verdict run_property(const CommandLine& line, const Limits& limits);

}  // namespace verifier
