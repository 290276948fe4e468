// Whose a variable is.
// SPDX-License-Identifier: MIT
#include "automata/owner.hpp"

#include <string>

namespace rmpl::automata {

std::optional<ComponentId> owner_of(const Plant& plant, VariableId variable) {
  if (const auto component = plant.component_of(variable)) return component;
  const std::string& name = plant.variables.name(variable);
  return plant.find_component(name.substr(0, name.rfind('.')));
}

}  // namespace rmpl::automata
