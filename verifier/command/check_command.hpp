// tcca-check check: a file of properties.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/command_line.hpp"
#include "verifier/property/property.hpp"

namespace verifier {

/// Checks them all and prints the answers. Holds where all are as expected, is violated where one is not. Throws
/// InputError and Rejected.
Verdict run_check(const CommandLine& line, const Limits& limits);

}  // namespace verifier
