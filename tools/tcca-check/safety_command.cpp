// tcca-check safety.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/commands.hpp"
#include "tools/tcca-check/formula_check.hpp"

namespace rmpl::tools {

void add_safety(Program& program) {
  add_formula_check(program, {.never = true,
                              .name = "safety",
                              .description = "does a formula never hold? if not, print a timed counterexample",
                              .option = "--never",
                              .meaning = "a formula that must never hold"});
}

}  // namespace rmpl::tools
