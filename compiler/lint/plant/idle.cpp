// Findings: transitions that lead where the component is, and weights, that take nothing from others.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "compiler/lint/plant/beside.hpp"
#include "compiler/lint/plant/findings.hpp"

namespace rmpl::compiler {

using automata::Component;
using automata::ComponentId;
using automata::Transition;
using automata::TransitionId;
using automata::Weight;

namespace {

/// Nominal transitions that can happen, of which `holds` is so.
template <class Holds>
std::vector<PlantTransition> nominal_where(const PlantAnalysis& analysis, const Holds& holds) {
  std::vector<PlantTransition> found;
  const automata::Plant& plant = analysis.plant();
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const Component& component = plant.components[c];
    for (std::size_t t = 0; t < component.transitions.size(); ++t) {
      const PlantTransition candidate{ComponentId(c), TransitionId(t)};
      if (component.is_fault(component.transitions[t]) || !analysis.can_happen(candidate)) continue;
      if (holds(component, component.transitions[t], candidate)) found.push_back(candidate);
    }
  }
  return found;
}

/// Whether the transition has other outcomes.
bool is_one_of_several(const Component& component, const Transition& transition) {
  return std::count_if(component.transitions.begin(), component.transitions.end(), [&](const Transition& other) {
           return other.branch == transition.branch && other.from == transition.from;
         }) > 1;
}

}  // namespace

std::vector<PlantTransition> find_idle_transitions(PlantAnalysis& analysis) {
  return nominal_where(analysis, [&](const Component& component, const Transition& transition, PlantTransition id) {
    // What has no time bounds goes before what has.
    const auto counts = [&](const Transition& other) {
      return !component.is_fault(other) && (other.timing || !transition.timing);
    };
    return transition.from == transition.to && !may_be_beside(analysis, id, counts);
  });
}

std::vector<PlantTransition> find_unused_weights(PlantAnalysis& analysis) {
  return nominal_where(analysis, [&](const Component& component, const Transition& transition, PlantTransition id) {
    if (transition.weight.kind == Weight::Kind::none || transition.weight.value >= 1) return false;
    if (is_one_of_several(component, transition)) return false;
    const auto counts = [&](const Transition& other) { return !component.is_fault(other) && !other.timing; };
    return transition.timing || !may_be_beside(analysis, id, counts);
  });
}

}  // namespace rmpl::compiler
