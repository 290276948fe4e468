// tcca-check reachability.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/commands.hpp"
#include "tools/tcca-check/formula_check.hpp"

namespace rmpl::tools {

void add_reachability(Program& program) {
  add_formula_check(
      program, {.never = false,
                .name = "reachability",
                .description = "can the plant reach a state in which a formula holds? if so, print a timed witness",
                .option = "--target",
                .meaning = "the target formula"});
}

}  // namespace rmpl::tools
