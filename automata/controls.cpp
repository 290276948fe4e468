// Looked up in the list of controls.
// SPDX-License-Identifier: MIT
#include "automata/controls.hpp"

#include <algorithm>

namespace rmpl::automata {

bool is_control(const Plant& plant, VariableId variable) {
  return std::any_of(plant.controls.begin(), plant.controls.end(),
                     [variable](const Control& control) { return control.variable == variable; });
}

bool speaks_of_control(const Plant& plant, const Formula& formula) {
  const std::vector<VariableId> read = variables_of(formula);
  return std::any_of(read.begin(), read.end(), [&](VariableId variable) { return is_control(plant, variable); });
}

}  // namespace rmpl::automata
