// Names in their roles, and what is said where they play none.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/log_names.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "automata/controls.hpp"
#include "automata/facade.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;
using Role = LogReader::Role;

/// The names that make sense in a role, in declaration order.
std::vector<std::string_view> candidates(const automata::Plant& plant, Role role) {
  std::vector<std::string_view> names;
  switch (role) {
    case Role::command:
      for (const automata::Control& control : plant.controls)
        names.emplace_back(plant.variables.name(control.variable));
      break;
    case Role::estimate:
      for (const automata::Component& component : plant.components) names.emplace_back(component.name);
      break;
    case Role::observations:
      for (const automata::Variable& variable : plant.variables) {
        if (!plant.find_component(variable.name)) names.emplace_back(variable.name);
      }
      break;
  }
  return names;
}

std::string_view noun(Role role) {
  switch (role) {
    case Role::command:
      return "control variable";
    case Role::estimate:
      return "component";
    case Role::observations:
      return "variable";
  }
  return {};
}

/// Whether a variable makes sense in a role.
bool plays(const automata::Plant& plant, Role role, automata::VariableId variable) {
  switch (role) {
    case Role::command:
      return automata::is_control(plant, variable);
    case Role::estimate:
      return plant.component_of(variable).has_value();
    case Role::observations:  // what the software of a facade tells may be seen
      return !plant.component_of(variable) ||
             std::find(plant.observables.begin(), plant.observables.end(), variable) != plant.observables.end();
  }
  return false;
}

[[noreturn]] void refuse_mode(const std::string& name) {
  throw base::InputError(" '" + name + "' is a component: no sensor reads its mode; expected an attribute");
}

automata::ValueId value_of(const automata::Variable& variable, const std::string& value) {
  const auto known = variable.find(value);
  if (!known) {
    throw base::InputError(" '" + value + "' is no value of '" + variable.name + "'" +
                           base::suggestion(value, variable.values));
  }
  return *known;
}

}  // namespace

Assignment resolve(const automata::Plant& plant, LogReader::Role role, const std::string& name,
                   const std::string& value) {
  const auto variable = plant.variables.find(name);
  if (role == Role::observations && variable && !plays(plant, role, *variable)) refuse_mode(name);
  if (!variable || !plays(plant, role, *variable)) {
    throw base::InputError(" '" + name + "' is no " + std::string(noun(role)) + " of plant '" + plant.name + "'" +
                           base::suggestion(name, candidates(plant, role)));
  }
  return {*variable, value_of(plant.variables[*variable], value)};
}

Assignment resolve(const automata::ModelProgram& program, LogReader::Role role, const std::string& name,
                   const std::string& value) {
  std::vector<std::string_view> names;
  if (role == Role::command) {
    for (const auto& control : program.controls) names.emplace_back(program.variables.name(control.variable));
  } else {
    for (const automata::Variable& variable : program.variables) names.emplace_back(variable.name);
  }
  const auto variable = program.variables.find(name);
  if (role == Role::observations && variable && automata::is_mode(program, *variable)) refuse_mode(name);
  if (!variable || std::find(names.begin(), names.end(), name) == names.end()) {
    const std::string noun = role == Role::command ? "control variable" : "variable";
    throw base::InputError(" '" + name + "' is no " + noun + " of model program '" + program.name + "'" +
                           base::suggestion(name, names));
  }
  return {*variable, value_of(program.variables[*variable], value)};
}

}  // namespace rmpl::runtime
