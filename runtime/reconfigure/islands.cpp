// Islands, by union and find over the variables.
// SPDX-License-Identifier: MIT
#include "runtime/reconfigure/islands.hpp"

#include <numeric>
#include <utility>

namespace runtime {

using automata::Component;
using automata::ComponentId;
using automata::Formula;
using automata::VariableId;

namespace {

class Partition {
 public:
  explicit Partition(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  std::size_t root(std::size_t member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  /// The smaller root stays, so that the order of the parts is that of their first members.
  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    if (b < a) std::swap(a, b);
    parent_[b] = a;
  }
  void join(VariableId hub, const Formula& formula) {
    for (const VariableId v : variables_of(formula)) join(hub.index(), v.index());
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

Islands::Islands(const automata::Plant& plant, std::span<const ComponentId> joined) {
  Partition partition(plant.variables.size());
  for (const Formula& formula : plant.interconnections) {
    const auto read = variables_of(formula);
    if (!read.empty()) partition.join(read.front(), formula);
  }
  for (const Component& component : plant.components) {
    for (const auto& mode : component.modes) partition.join(component.mode, mode.constraint);
    for (const auto& transition : component.transitions) partition.join(component.mode, transition.guard);
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

}  // namespace runtime
