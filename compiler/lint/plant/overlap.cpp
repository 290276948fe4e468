// Finding: untimed nominal transitions between which chance decides, though nothing says how.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "compiler/lint/plant/findings.hpp"

namespace rmpl::compiler {

using automata::Component;
using automata::ComponentId;
using automata::Formula;
using automata::Transition;
using automata::TransitionId;

namespace {

/// Whether one conjunct of each guard keeps a variable to values that the other excludes: what most guards are told
/// apart by, and no question needs to be asked.
bool plainly_exclude(const Formula& a, const Formula& b) {
  const auto left = conjuncts_of(a);
  const auto right = conjuncts_of(b);
  const auto disjoint = [](const Formula& x, const Formula& y) {
    return x.kind == Formula::Kind::member && y.kind == Formula::Kind::member && x.variable == y.variable &&
           std::none_of(x.values.begin(), x.values.end(), [&](automata::ValueId value) {
             return std::binary_search(y.values.begin(), y.values.end(), value);
           });
  };
  return std::any_of(left.begin(), left.end(), [&](const Formula& x) {
    return std::any_of(right.begin(), right.end(), [&](const Formula& y) { return disjoint(x, y); });
  });
}

/// The untimed nominal transitions without weights that can happen.
std::vector<TransitionId> unweighted(const PlantAnalysis& analysis, ComponentId id) {
  std::vector<TransitionId> result;
  const Component& component = analysis.plant()[id];
  for (std::size_t t = 0; t < component.transitions.size(); ++t) {
    const Transition& transition = component.transitions[t];
    if (component.is_fault(transition) || transition.timing) continue;
    if (transition.weight.kind != automata::Weight::Kind::none) continue;
    if (analysis.can_happen({id, TransitionId(t)})) result.emplace_back(t);
  }
  return result;
}

}  // namespace

std::vector<Overlap> find_overlapping_guards(PlantAnalysis& analysis) {
  std::vector<Overlap> found;
  const automata::Plant& plant = analysis.plant();
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const Component& component = plant.components[c];
    const std::vector<TransitionId> candidates = unweighted(analysis, ComponentId(c));
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      for (std::size_t j = i + 1; j < candidates.size(); ++j) {
        const Transition& a = component.transitions[candidates[i].index()];
        const Transition& b = component.transitions[candidates[j].index()];
        if (a.from != b.from || a.to == b.to || plainly_exclude(a.guard, b.guard)) continue;
        const std::array guards{&a.guard, &b.guard};
        Implied both = analysis.questions().implied(ComponentId(c), a.from, guards);
        if (both.verdict != Implied::Verdict::yes) continue;
        found.push_back({ComponentId(c), candidates[i], candidates[j], std::move(both.context), std::move(both.read)});
      }
    }
  }
  return found;
}

}  // namespace rmpl::compiler
