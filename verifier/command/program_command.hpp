// tcca-check program: what can become of a program that controls a plant.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/command_line.hpp"
#include "verifier/explore/limits.hpp"

namespace verifier {

/// Checks, prints the answer, and returns the exit status. Throws InputError and Rejected.
int run_program(const CommandLine& line, const Limits& limits);

}  // namespace verifier
