// A part of a plant.
// SPDX-License-Identifier: MIT
#include "verifier/slice/part.hpp"

#include <algorithm>

namespace rmpl::verifier {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::ControlAction;
using automata::Formula;
using automata::Modes;
using automata::Plant;
using automata::VariableId;

Part::Part(const Plant& whole, const Kept& kept)
    : own_(whole.variables.size()), components_(kept.components), idle_(automata::idle_action(whole)) {
  plant_.name = whole.name;
  for (std::size_t v = 0; v < own_.size(); ++v) {
    if (!kept.variables[v]) continue;
    own_[v] = VariableId(plant_.variables.size());
    plant_.variables.add(whole.variables[VariableId(v)]);
  }
  for (const ComponentId c : components_) {
    Component component = whole[c];
    component.mode = *own_[component.mode.index()];
    for (automata::Mode& mode : component.modes) mode.constraint = into(mode.constraint);
    for (automata::Transition& t : component.transitions) t.guard = into(t.guard);
    plant_.components.push_back(std::move(component));
  }
  for (const std::size_t q : kept.interconnections) {
    std::vector<Formula> conjuncts;
    for (const Formula& conjunct : automata::conjuncts_of(whole.interconnections[q].constraint)) {
      const std::vector<VariableId> variables = automata::variables_of(conjunct);
      const bool inside =
          std::any_of(variables.begin(), variables.end(), [&](VariableId v) { return own_[v.index()].has_value(); });
      if (inside) conjuncts.push_back(into(conjunct));
    }
    plant_.interconnections.emplace_back(automata::conjunction(std::move(conjuncts)), whole.interconnections[q].origin);
  }
  for (std::size_t i = 0; i < whole.controls.size(); ++i) {
    const auto& own = own_[whole.controls[i].variable.index()];
    if (!own) continue;
    controls_.push_back(i);
    plant_.controls.push_back({*own, whole.controls[i].idle});
  }
  for (const VariableId v : whole.observables) {
    if (const auto& own = own_[v.index()]) plant_.observables.push_back(*own);
  }
}

Formula Part::into(const Formula& formula) const {
  return automata::renamed(
      formula, [this](VariableId v) { return own_[v.index()].value(); },
      [](VariableId, automata::ValueId value) { return value; });
}

std::vector<Assignment> Part::into(const std::vector<Assignment>& assignments) const {
  std::vector<Assignment> result;
  for (const Assignment& a : assignments) {
    if (const auto& own = own_[a.variable.index()]) result.push_back({*own, a.value});
  }
  return result;
}

Modes Part::out(const Modes& modes, const Modes& rest) const {
  Modes result = rest;
  for (std::size_t c = 0; c < modes.size(); ++c) result[components_[c].index()] = modes[c];
  return result;
}

ControlAction Part::out(const ControlAction& action) const {
  ControlAction result = idle_;
  for (std::size_t i = 0; i < action.size(); ++i) result[controls_[i]] = action[i];
  return result;
}

}  // namespace rmpl::verifier
