// Ways to bring about transitions.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/ways.hpp"

#include <optional>

namespace rmpl::runtime {

using automata::ComponentId;

Ways::Ways(const automata::Plant& plant, const NominalGraph& graph, const CausalOrder& order) {
  std::vector<std::optional<ComponentId>> component_of(plant.variables.size());
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    component_of[plant.components[c].mode.index()] = ComponentId(c);
  }
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    auto& transitions = ways_.emplace_back(plant.components[c].transitions.size());
    for (const NominalTransition& t : graph.transitions(ComponentId(c))) {
      for (const Precondition& precondition : t.preconditions) {
        if (!order.goes_upstream(ComponentId(c), precondition)) continue;
        Way& way = transitions[t.id.index()].emplace_back(Way{&precondition, {}});
        for (const Requirement& r : precondition) {
          if (const auto upstream = component_of[r.variable.index()]) way.modes.push_back({*upstream, &r});
        }
      }
    }
  }
}

}  // namespace rmpl::runtime
