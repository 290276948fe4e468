// tcca-check program: what can become of a program that controls a plant.
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/tcca-check/command_line.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

/// Checks and prints the answer. Violated where a property is, or where a fault can lose the mission or keep the
/// program from ending. Throws base::InputError and Rejected.
Verdict run_program(const CommandLine& line, const Limits& limits);

}  // namespace rmpl::verifier
