// Findings: transitions that lead where the component is, and weights, that take nothing from others.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "compiler/lint/plant/beside.hpp"
#include "compiler/lint/plant/findings.hpp"
#include "compiler/lint/plant/nominal.hpp"

namespace rmpl::compiler {

using automata::Component;
using automata::Transition;
using automata::Weight;

namespace {

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
