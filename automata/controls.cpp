// Looked up in the list of controls.
// SPDX-License-Identifier: MIT
#include "automata/controls.hpp"

#include <algorithm>

namespace rmpl::automata {

std::optional<std::size_t> control_of(const Plant& plant, VariableId variable) {
  const auto at = std::find_if(plant.controls.begin(), plant.controls.end(),
                               [variable](const Control& control) { return control.variable == variable; });
  if (at == plant.controls.end()) return std::nullopt;
  return static_cast<std::size_t>(at - plant.controls.begin());
}

bool is_control(const Plant& plant, VariableId variable) { return control_of(plant, variable).has_value(); }

bool speaks_of_control(const Plant& plant, const Formula& formula) {
  const std::vector<VariableId> read = variables_of(formula);
  return std::any_of(read.begin(), read.end(), [&](VariableId variable) { return is_control(plant, variable); });
}

}  // namespace rmpl::automata
