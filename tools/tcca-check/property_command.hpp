// tcca-check reachability, safety, response.
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/tcca-check/command_line.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::verifier {

/// Checks one property of a plant and prints the answer. Throws base::InputError and Rejected.
Verdict run_property(const CommandLine& line, const Limits& limits);

}  // namespace rmpl::verifier
