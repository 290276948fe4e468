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

enum class Role { open, told, mode, commanded };

/// Per variable. What stands beside a mode in the location of a mode is an attribute of it, not a state.
std::vector<Role> roles_of(const ModelProgram& program) {
  std::vector<Role> roles(program.variables.size(), Role::open);
  for (const CommandedVariable& control : program.controls) roles[control.variable.index()] = Role::commanded;
  for (const ModelledComponent& component : program.components) roles[component.mode.index()] = Role::mode;
  for (const ModelLocation& location : program.locations) {
    const auto told = variables_of(location.told);
    const bool of_mode =
        std::any_of(told.begin(), told.end(), [&](VariableId v) { return roles[v.index()] == Role::mode; });
    if (of_mode) continue;
    for (const VariableId variable : told) {
      if (roles[variable.index()] == Role::open) roles[variable.index()] = Role::told;
    }
  }
  return roles;
}

std::vector<ModelledComponent>::const_iterator component_at(const ModelProgram& program, VariableId variable) {
  return std::find_if(program.components.begin(), program.components.end(),
                      [&](const ModelledComponent& one) { return one.mode == variable; });
}

Component component_of(const ModelProgram& program, VariableId variable) {
  Component component;
  component.name = program.variables.name(variable);
  component.mode = variable;
  component.origin = program.origin;
  for (const std::string& value : program.variables[variable].values) component.modes.emplace_back().name = value;
  component.modes.emplace_back().name.assign(1, '?');
  const auto modelled = component_at(program, variable);
  if (modelled == program.components.end()) return component;
  for (const ValueId fault : modelled->faults) component.modes[fault.index()].fault = true;
  return component;
}

}  // namespace

bool is_mode(const ModelProgram& program, VariableId variable) {
  return component_at(program, variable) != program.components.end();
}

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
    const bool seen = roles[v] == Role::told || roles[v] == Role::mode;
    if (seen) plant.components.push_back(component_of(program, VariableId(v)));
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
