// A model program seen from outside.
// SPDX-License-Identifier: MIT
#include "automata/facade.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "automata/scenario.hpp"
#include "base/check.hpp"

namespace rmpl::automata {
namespace {

enum class Role { open, told, commanded };

/// Per variable.
std::vector<Role> roles_of(const ModelProgram& program) {
  std::vector<Role> roles(program.variables.size(), Role::open);
  for (const CommandedVariable& control : program.controls) roles[control.variable.index()] = Role::commanded;
  for (const ModelLocation& location : program.locations) {
    for (const VariableId variable : variables_of(location.told)) {
      if (roles[variable.index()] == Role::open) roles[variable.index()] = Role::told;
    }
  }
  return roles;
}

Component component_of(const ModelProgram& program, VariableId variable) {
  Component component;
  component.name = program.variables.name(variable);
  component.mode = variable;
  component.origin = program.origin;
  for (const std::string& value : program.variables[variable].values) component.modes.emplace_back().name = value;
  component.modes.emplace_back().name.assign(1, '?');
  return component;
}

}  // namespace

bool can_be_flown(const ModelProgram& program) {
  return std::all_of(program.controls.begin(), program.controls.end(),
                     [](const CommandedVariable& control) { return control.idle.has_value(); });
}

Plant facade_of(const ModelProgram& program) {
  CHECK(can_be_flown(program));
  Plant plant;
  plant.name = program.name;
  plant.variables = program.variables;
  plant.interconnections = program.constraints;
  plant.observables = program.observables;
  for (const CommandedVariable& control : program.controls) {
    plant.controls.push_back({control.variable, *control.idle});
  }
  const std::vector<Role> roles = roles_of(program);
  for (std::size_t v = 0; v < roles.size(); ++v) {
    if (roles[v] == Role::told) plant.components.push_back(component_of(program, VariableId(v)));
  }
  return plant;
}

std::size_t add_model(Document& document, ModelProgram model) {
  const std::size_t position = document.models.size();
  document.models.push_back(std::move(model));
  if (can_be_flown(document.models.back())) document.facades.emplace(position, facade_of(document.models.back()));
  return position;
}

}  // namespace rmpl::automata
