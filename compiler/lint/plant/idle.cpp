// Findings: transitions that lead where the component is, and weights, that take nothing from others.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "automata/clock_use.hpp"
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

/// Whether a weight, below 1, is to divide the probability among untimed transitions.
bool has_weight_of_its_own(const Component& component, const Transition& transition) {
  return transition.weight.kind != Weight::Kind::none && transition.weight.value < 1 &&
         !is_one_of_several(component, transition);
}

bool is_untimed(const Component& component, const Transition& transition) {
  return !component.is_fault(transition) && !transition.timing;
}

/// That all controls are idle.
automata::Formula at_rest(const automata::Plant& plant) {
  std::vector<automata::Formula> idle;
  for (const automata::Control& control : plant.controls) idle.push_back(automata::is(control.variable, control.idle));
  return automata::conjunction(std::move(idle));
}

}  // namespace

std::vector<PlantTransition> find_idle_transitions(PlantAnalysis& analysis) {
  return nominal_where(analysis, [&](const Component& component, const Transition& transition, PlantTransition id) {
    // What has no time bounds goes before what has.
    const auto counts = [&](const Transition& other) {
      return !component.is_fault(other) && (other.timing || !transition.timing);
    };
    if (transition.restart && automata::needs_clock(component, transition.from)) return false;
    return transition.from == transition.to && !may_be_beside(analysis, id, counts);
  });
}

std::vector<PlantTransition> find_unused_weights(PlantAnalysis& analysis) {
  return nominal_where(analysis, [&](const Component& component, const Transition& transition, PlantTransition id) {
    if (!has_weight_of_its_own(component, transition)) return false;
    const auto counts = [&](const Transition& other) { return is_untimed(component, other); };
    return transition.timing || !may_be_beside(analysis, id, counts);
  });
}

std::vector<PlantTransition> find_weights_unused_at_rest(PlantAnalysis& analysis) {
  return nominal_where(analysis, [&](const Component& component, const Transition& transition, PlantTransition id) {
    if (transition.timing || !has_weight_of_its_own(component, transition)) return false;
    const auto counts = [&](const Transition& other) { return is_untimed(component, other); };
    if (!may_be_beside(analysis, id, counts)) return false;  // has none under any command
    const automata::Formula rest = at_rest(analysis.plant());
    const std::array guards{&transition.guard, &rest};
    if (analysis.questions().implied(id.component, transition.from, guards).verdict != Implied::Verdict::yes)
      return false;
    return !may_be_beside(analysis, id, counts, rest);
  });
}

}  // namespace rmpl::compiler
