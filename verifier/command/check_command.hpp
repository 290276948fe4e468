// tcca-check check: a file of properties.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/command_line.hpp"
#include "verifier/explore/limits.hpp"

namespace verifier {

/// Checks them all, prints the answers, and returns the exit status. Throws InputError and Rejected.
int run_check(const CommandLine& line, const Limits& limits);

}  // namespace verifier
