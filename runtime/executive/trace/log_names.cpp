// Names in their roles, and what is said where they play none.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/log_names.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

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

LogNames::LogNames(const automata::Plant& plant) : plant_(plant), index_(plant) {}

Assignment LogNames::resolve(Role role, const std::string& name, const std::string& value) const {
  const auto variable = plant_.variables.find(name);
  if (role == Role::observations && variable && !plays(role, *variable)) refuse_mode(name);
  if (!variable || !plays(role, *variable)) {
    throw base::InputError(" '" + name + "' is no " + std::string(noun(role)) + " of plant '" + plant_.name + "'" +
                           base::suggestion(name, candidates(plant_, role)));
  }
  return {*variable, value_of(plant_.variables[*variable], value)};
}

automata::Modes LogNames::all_modes(const std::vector<Assignment>& told) const {
  automata::Modes modes;
  for (const automata::Component& component : plant_.components) {
    const auto known =
        std::find_if(told.begin(), told.end(), [&](const Assignment& one) { return one.variable == component.mode; });
    if (known == told.end()) {
      throw base::InputError(" expected the mode of every component, and '" + component.name + "' has none");
    }
    modes.emplace_back(known->value.index());
  }
  return modes;
}

/// Whether a variable makes sense in a role.
bool LogNames::plays(Role role, automata::VariableId variable) const {
  switch (role) {
    case Role::command:
      return index_.control_of(variable).has_value();
    case Role::estimate:
      return index_.component_of(variable).has_value();
    case Role::observations:
      return !index_.component_of(variable);
  }
  return false;
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
  if (!variable || std::find(names.begin(), names.end(), name) == names.end()) {
    const std::string noun = role == Role::command ? "control variable" : "variable";
    throw base::InputError(" '" + name + "' is no " + noun + " of model program '" + program.name + "'" +
                           base::suggestion(name, names));
  }
  return {*variable, value_of(program.variables[*variable], value)};
}

}  // namespace rmpl::runtime
