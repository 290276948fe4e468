// Islands, by a partition of the variables.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/islands.hpp"

#include "base/partition.hpp"

namespace rmpl::runtime {

using automata::Component;
using automata::ComponentId;
using automata::Formula;
using automata::VariableId;

Islands::Islands(const automata::Plant& plant, std::span<const ComponentId> joined) {
  base::Partition partition(plant.variables.size());
  const auto join = [&](VariableId hub, const Formula& formula) {
    for (const VariableId v : variables_of(formula)) partition.join(hub.index(), v.index());
  };
  for (const Formula& formula : plant.interconnections) {
    const auto read = variables_of(formula);
    if (!read.empty()) join(read.front(), formula);
  }
  for (const Component& component : plant.components) {
    for (const auto& mode : component.modes) join(component.mode, mode.constraint);
    for (const auto& transition : component.transitions) join(component.mode, transition.guard);
  }
  for (const ComponentId c : joined) partition.join(plant[joined.front()].mode.index(), plant[c].mode.index());

  std::vector<std::size_t> island_of(plant.variables.size());
  for (std::size_t v = 0; v < plant.variables.size(); ++v) {
    const std::size_t root = partition.root(v);
    if (root == v) {
      island_of[v] = variables_.size();
      variables_.emplace_back();
    } else {
      island_of[v] = island_of[root];
    }
    variables_[island_of[v]].emplace_back(v);
  }
  components_.resize(variables_.size());
  controls_.resize(variables_.size());
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    of_component_.push_back(island_of[plant.components[c].mode.index()]);
    components_[of_component_.back()].emplace_back(c);
  }
  for (std::size_t i = 0; i < plant.controls.size(); ++i) {
    controls_[island_of[plant.controls[i].variable.index()]].push_back(i);
  }
}

}  // namespace rmpl::runtime
