// Regions, as the dependencies of the plant have them.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/nominal/regions.hpp"

#include <algorithm>
#include <iterator>

#include "automata/dependencies/dependencies.hpp"

namespace rmpl::runtime {

using automata::Plant;
using automata::ValueId;
using automata::VariableId;

/// The classes of attributes, then the decisions that the constraints of each region read.
Regions::Regions(const Plant& plant, std::size_t variables) {
  const automata::Dependencies dependencies(plant);
  const automata::Classes classes = dependencies.regions();
  const auto decided = [&](VariableId v) { return !classes[v].has_value(); };
  std::vector<std::vector<VariableId>> constraints;
  for (const automata::Dependencies::Reading& reading : dependencies.constraints()) {
    auto& read = constraints.emplace_back(reading.variables);
    if (reading.constraint.under) read.push_back(reading.constraint.under->variable);
  }
  regions_.resize(classes.count);
  region_of_.assign(classes.of.begin(), classes.of.end());
  for (std::size_t v = 0; v < variables; ++v) {
    if (region_of_[v]) regions_[*region_of_[v]].attributes.emplace_back(v);
  }
  neighbours_.resize(variables);
  for (const auto& read : constraints) {
    const auto first = std::find_if(read.begin(), read.end(), [&](VariableId v) { return !decided(v); });
    if (first == read.end()) continue;
    for (const VariableId v : read) {
      if (decided(v)) continue;
      std::copy_if(read.begin(), read.end(), std::back_inserter(neighbours_[v.index()]),
                   [&](VariableId w) { return w != v && !decided(w); });
    }
    auto& decisions = regions_[*region_of_[first->index()]].decisions;
    std::copy_if(read.begin(), read.end(), std::back_inserter(decisions), [&](VariableId v) { return decided(v); });
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
