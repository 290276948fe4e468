// The subcommands of tcca-check: each adds itself to the program, with its options.
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/shared/program.hpp"

namespace rmpl::tools {

void add_reachability(Program& program);
void add_safety(Program& program);
void add_response(Program& program);
void add_stuck(Program& program);
void add_program(Program& program);
void add_check(Program& program);
void add_export(Program& program);
void add_probability(Program& program);
void add_fault_tree(Program& program);
void add_fmea(Program& program);

}  // namespace rmpl::tools
