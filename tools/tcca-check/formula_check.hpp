// Whether a formula can come to hold: reachability and safety, of plants and of model programs.
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/shared/program.hpp"
#include "verifier/marking/question.hpp"

namespace rmpl::tools {

/// What the two subcommands differ in.
struct FormulaCheck {
  verifier::MarkingQuestion::Kind kind;
  const char* name;         ///< of the subcommand
  const char* description;  ///< of the subcommand
  const char* option;       ///< that takes the formula
  const char* meaning;      ///< of that option
};

void add_formula_check(Program& program, const FormulaCheck& check);

}  // namespace rmpl::tools
