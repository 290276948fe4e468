// The nominal transitions of a plant, one by one.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "compiler/lint/plant/analysis.hpp"

namespace rmpl::compiler {

/// Nominal transitions that can happen, of which `holds` is so.
template <class Holds>
std::vector<PlantTransition> nominal_where(const PlantAnalysis& analysis, const Holds& holds) {
  std::vector<PlantTransition> found;
  const automata::Plant& plant = analysis.plant();
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const automata::Component& component = plant.components[c];
    for (std::size_t t = 0; t < component.transitions.size(); ++t) {
      const PlantTransition candidate{automata::ComponentId(c), automata::TransitionId(t)};
      if (component.is_fault(component.transitions[t]) || !analysis.can_happen(candidate)) continue;
      if (holds(component, component.transitions[t], candidate)) found.push_back(candidate);
    }
  }
  return found;
}

}  // namespace rmpl::compiler
