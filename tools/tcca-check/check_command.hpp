// tcca-check check: a file of properties.
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/tcca-check/command_line.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

/// Checks them all and prints the answers. Holds where all are as expected, is violated where one is not. Throws
/// base::InputError and Rejected.
Verdict run_check(const CommandLine& line, const Limits& limits);

}  // namespace rmpl::verifier
