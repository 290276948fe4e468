// Variables by which modes are left out of a question.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/plant.hpp"

namespace rmpl::compiler {

/// Adds for each mode of each component, in order, a variable of two values: what excludes the mode is the second.
void add_exclusions(automata::Variables& variables, const automata::Plant& plant);

}  // namespace rmpl::compiler
