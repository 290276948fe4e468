// Attributes that make no difference.
// SPDX-License-Identifier: MIT
#include "automata/store/relevance.hpp"

#include "automata/store/elimination.hpp"

namespace rmpl::automata {
namespace {

/// Neither a mode, nor a control, nor read by a guard.
std::vector<VariableId> unread(const Plant& plant) {
  std::vector<bool> read(plant.variables.size(), false);
  for (const Control& control : plant.controls) read[control.variable.index()] = true;
  for (const Component& component : plant.components) {
    read[component.mode.index()] = true;
    for (const Transition& t : component.transitions) {
      for (const VariableId v : variables_of(t.guard)) read[v.index()] = true;
    }
  }
  std::vector<VariableId> result;
  for (std::size_t v = 0; v < read.size(); ++v) {
    if (!read[v]) result.emplace_back(v);
  }
  return result;
}

}  // namespace

Plant relevant_part(const Plant& plant) {
  const std::vector<Constraint> constraints = constraints_of(plant);
  const Elimination elimination(plant.variables, constraints, unread(plant));
  Plant part = plant;
  part.variables = {};
  for (std::size_t v = 0; v < plant.variables.size(); ++v) {
    Variable variable = plant.variables[VariableId(v)];
    if (elimination.has_gone(VariableId(v))) variable.values.resize(1);
    part.variables.add(std::move(variable));
  }
  std::erase_if(part.observables, [&](VariableId v) { return elimination.has_gone(v); });
  part.interconnections.clear();
  std::vector<std::vector<std::vector<Formula>>> by_mode;
  for (const Component& component : plant.components) by_mode.emplace_back(component.modes.size());
  for (const std::size_t left : elimination.left()) {
    const Constraint& c = constraints[left];
    if (c.under) {
      by_mode[plant.component_of(c.under->variable)->index()][c.under->value.index()].push_back(c.formula);
    } else {
      part.interconnections.emplace_back(c.formula);
    }
  }
  for (std::size_t c = 0; c < by_mode.size(); ++c) {
    for (std::size_t m = 0; m < by_mode[c].size(); ++m) {
      part.components[c].modes[m].constraint = conjunction(std::move(by_mode[c][m]));
    }
  }
  return part;
}

}  // namespace rmpl::automata
