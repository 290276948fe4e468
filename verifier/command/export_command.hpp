// tcca-check export: the same question for another tool.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/command_line.hpp"
#include "verifier/explore/limits.hpp"

namespace verifier {

/// Prints the model and the question; false where a limit was reached first. Throws InputError, where the tool cannot
/// say it too, and Rejected.
bool run_export(const CommandLine& line, const Limits& limits);

}  // namespace verifier
