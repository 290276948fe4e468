// Finding: transitions that lead where the component is, and take nothing from others.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "compiler/lint/plant/findings.hpp"

namespace rmpl::compiler {

using automata::Component;
using automata::ComponentId;
using automata::Transition;
using automata::TransitionId;

namespace {

/// Whether no nominal transition that leads elsewhere is ever enabled with it.
bool is_alone(PlantAnalysis& analysis, PlantTransition idle) {
  const Component& component = analysis.plant()[idle.component];
  const Transition& own = component.transitions[idle.transition.index()];
  for (std::size_t t = 0; t < component.transitions.size(); ++t) {
    const Transition& other = component.transitions[t];
    if (other.from != own.from || other.to == own.to || component.is_fault(other)) continue;
    if (!analysis.can_happen({idle.component, TransitionId(t)})) continue;
    const std::array guards{&own.guard, &other.guard};
    const Implied both = analysis.questions().implied(idle.component, own.from, guards);
    if (both.verdict != Implied::Verdict::no) return false;
  }
  return true;
}

}  // namespace

std::vector<PlantTransition> find_idle_transitions(PlantAnalysis& analysis) {
  std::vector<PlantTransition> found;
  const automata::Plant& plant = analysis.plant();
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const Component& component = plant.components[c];
    for (std::size_t t = 0; t < component.transitions.size(); ++t) {
      const PlantTransition candidate{ComponentId(c), TransitionId(t)};
      const Transition& transition = component.transitions[t];
      if (transition.from != transition.to || component.is_fault(transition)) continue;
      if (analysis.can_happen(candidate) && is_alone(analysis, candidate)) found.push_back(candidate);
    }
  }
  return found;
}

}  // namespace rmpl::compiler
