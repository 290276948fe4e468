// Parts: the parts of a plant, as its dependencies have them.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/parts.hpp"

#include <numeric>
#include <optional>

#include "automata/dependencies/dependencies.hpp"

namespace rmpl::runtime {

using automata::ComponentId;

Parts::Parts(const automata::Plant& plant, std::span<const ComponentId> joined) {
  const automata::Classes classes = automata::Dependencies(plant).parts();
  std::vector<std::size_t> same(classes.count);  // the class that each goes with: itself, but for those that are joined
  std::iota(same.begin(), same.end(), std::size_t{0});
  for (const ComponentId c : joined) same[*classes[plant[c].mode]] = *classes[plant[joined.front()].mode];

  std::vector<std::size_t> part_of(plant.variables.size());
  std::vector<std::optional<std::size_t>> number(classes.count);
  for (std::size_t v = 0; v < plant.variables.size(); ++v) {
    auto& part = number[same[*classes.of[v]]];
    if (!part) {
      part = variables_.size();
      variables_.emplace_back();
    }
    part_of[v] = *part;
    variables_[*part].emplace_back(v);
  }
  components_.resize(variables_.size());
  controls_.resize(variables_.size());
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    of_component_.push_back(part_of[plant.components[c].mode.index()]);
    components_[of_component_.back()].emplace_back(c);
  }
  for (std::size_t i = 0; i < plant.controls.size(); ++i) {
    controls_[part_of[plant.controls[i].variable.index()]].push_back(i);
  }
}

}  // namespace rmpl::runtime
