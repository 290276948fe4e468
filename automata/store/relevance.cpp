// What of a store matters: a closure over who was eliminated with what.
// SPDX-License-Identifier: MIT
#include "automata/store/relevance.hpp"

#include <algorithm>

#include "automata/dependencies/plant_index.hpp"
#include "automata/store/elimination.hpp"

namespace rmpl::automata {

/// An attribute that goes is decided by the constraints that it takes with it. When it goes they read nothing that went
/// before: all of them that did are gone. So those of a part are closed, and what is outside can be eliminated in the
/// same order as in the whole.
Relevance::Relevance(const Plant& plant)
    : constraints_(constraints_of(plant)), decided_by_(plant.variables.size()), met_(plant.variables.size()) {
  const PlantIndex index(plant);
  std::vector<VariableId> attributes;
  for (std::size_t v = 0; v < plant.variables.size(); ++v) {
    if (!index.component_of(VariableId(v)) && !index.control_of(VariableId(v))) attributes.emplace_back(v);
  }
  for (const Constraint& constraint : constraints_) {
    auto& read = read_.emplace_back(variables_of(constraint.formula));
    if (constraint.under) read.push_back(constraint.under->variable);
  }
  told_.resize(constraints_.size());
  const Elimination elimination(plant.variables, constraints_, attributes);
  excludes_ = !elimination.left().empty();
  for (const std::size_t left : elimination.left()) {
    for (const VariableId v : read_[left]) decided_by_[v.index()].push_back(left);
  }
  for (const VariableId v : attributes) {
    if (!elimination.has_gone(v)) continue;
    const auto& taken = elimination.taken_by(v);
    decided_by_[v.index()].assign(taken.begin(), taken.end());
  }
}

Relevance::Part Relevance::part(const std::vector<VariableId>& of) {
  Part part;
  const auto meet = [&](VariableId v) {
    if (!met_[v.index()]) part.variables.push_back(v);
    met_[v.index()] = true;
  };
  for (const VariableId v : of) meet(v);
  for (std::size_t i = 0; i < part.variables.size(); ++i) {
    for (const std::size_t constraint : decided_by_[part.variables[i].index()]) {
      if (told_[constraint]) continue;
      told_[constraint] = true;
      part.constraints.push_back(constraint);
      for (const VariableId v : read_[constraint]) meet(v);
    }
  }
  for (const VariableId v : part.variables) met_[v.index()] = false;
  for (const std::size_t constraint : part.constraints) told_[constraint] = false;
  std::sort(part.variables.begin(), part.variables.end());
  std::sort(part.constraints.begin(), part.constraints.end());
  return part;
}

}  // namespace rmpl::automata
