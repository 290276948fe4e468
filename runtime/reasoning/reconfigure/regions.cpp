// Regions, by a partition of the attributes.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/regions.hpp"

#include <algorithm>
#include <iterator>

#include "base/partition.hpp"

namespace rmpl::runtime {

using automata::Component;
using automata::Formula;
using automata::Plant;
using automata::ValueId;
using automata::VariableId;

/// A partition of the attributes, then the decisions that the constraints of each region read.
Regions::Regions(const Plant& plant, std::size_t variables) {
  std::vector<bool> decided(variables);
  for (const Component& component : plant.components) decided[component.mode.index()] = true;
  for (const automata::Control& control : plant.controls) decided[control.variable.index()] = true;

  std::vector<std::vector<VariableId>> constraints;
  const auto constrain = [&](const Formula& formula, std::optional<VariableId> mode) {
    for (const Formula& conjunct : conjuncts_of(formula)) {
      auto& read = constraints.emplace_back(variables_of(conjunct));
      if (mode) read.push_back(*mode);
    }
  };
  for (const Formula& q : plant.interconnections) constrain(q, std::nullopt);
  for (const Component& component : plant.components) {
    for (const auto& mode : component.modes) constrain(mode.constraint, component.mode);
  }

  base::Partition partition(variables);
  const auto first_attribute = [&](const std::vector<VariableId>& read) {
    return std::find_if(read.begin(), read.end(), [&](VariableId v) { return !decided[v.index()]; });
  };
  for (const auto& read : constraints) {
    const auto first = first_attribute(read);
    for (auto v = first; v != read.end(); ++v) {
      if (!decided[v->index()]) partition.join(v->index(), first->index());
    }
  }
  region_of_.resize(variables);
  for (std::size_t v = 0; v < variables; ++v) {
    if (decided[v]) continue;
    auto& region = region_of_[partition.root(v)];
    if (!region) {
      region = regions_.size();
      regions_.emplace_back();
    }
    region_of_[v] = region;
    regions_[*region].attributes.emplace_back(v);
  }
  neighbours_.resize(variables);
  for (const auto& read : constraints) {
    const auto first = first_attribute(read);
    if (first == read.end()) continue;
    for (const VariableId v : read) {
      if (decided[v.index()]) continue;
      std::copy_if(read.begin(), read.end(), std::back_inserter(neighbours_[v.index()]),
                   [&](VariableId w) { return w != v && !decided[w.index()]; });
    }
    auto& decisions = regions_[*region_of_[first->index()]].decisions;
    std::copy_if(read.begin(), read.end(), std::back_inserter(decisions),
                 [&](VariableId v) { return decided[v.index()]; });
  }
  readers_.resize(variables);
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    for (std::size_t m = 0; m < plant.components[c].modes.size(); ++m) {
      for (const VariableId v : variables_of(plant.components[c].modes[m].constraint)) {
        readers_[v.index()].push_back({plant.components[c].mode, ValueId(m)});
      }
    }
  }
  for (Region& region : regions_) {
    std::sort(region.decisions.begin(), region.decisions.end());
    region.decisions.erase(std::unique(region.decisions.begin(), region.decisions.end()), region.decisions.end());
  }
}

}  // namespace rmpl::runtime
