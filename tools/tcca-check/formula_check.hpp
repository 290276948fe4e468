// Whether a formula can come to hold: reachability and safety.
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/shared/program.hpp"

namespace rmpl::tools {

/// What the two subcommands differ in.
struct FormulaCheck {
  bool never;               ///< the formula is never to hold
  const char* name;         ///< of the subcommand
  const char* description;  ///< of the subcommand
  const char* option;       ///< that takes the formula
  const char* meaning;      ///< of that option
};

void add_formula_check(Program& program, const FormulaCheck& check);

}  // namespace rmpl::tools
