// Prefixes of names.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/own_names.hpp"

namespace rmpl::compiler {

bool is_of(std::string_view name, std::string_view instance) {
  if (instance.empty()) return true;
  return name.size() > instance.size() + 1 && name.starts_with(instance) && name[instance.size()] == '.';
}

automata::Variables own_names(const automata::Plant& plant, std::string_view instance) {
  automata::Variables table;
  for (const automata::Variable& variable : plant.variables) {
    automata::Variable own = variable;
    if (!instance.empty() && is_of(own.name, instance)) {
      own.name.erase(0, instance.size() + 1);
      if (plant.variables.find(own.name)) own.name = variable.name;
    }
    table.add(std::move(own));
  }
  return table;
}

}  // namespace rmpl::compiler
