// tcca-check export: the same question for another tool.
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/tcca-check/command_line.hpp"
#include "verifier/search/limits.hpp"

namespace rmpl::verifier {

/// Prints the model and the question; false where a limit was reached first. Throws base::InputError, where the tool
/// cannot say it too, and Rejected.
bool run_export(const CommandLine& line, const Limits& limits);

}  // namespace rmpl::verifier
