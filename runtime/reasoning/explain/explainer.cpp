// What changed for the worse, and why.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/explain/explainer.hpp"

#include <algorithm>

namespace rmpl::runtime {

std::vector<Evidence> Explainer::evidence_of_new(const automata::Modes& before, const Estimator& estimator,
                                                 const automata::Observation& observation) {
  std::vector<Evidence> result;
  const Estimate& estimate = estimator.estimate();
  if (!estimate.follows || !estimator.tells_rivals()) return result;
  for (std::size_t c = 0; c < before.size(); ++c) {
    const automata::ComponentId component(c);
    const automata::ModeId mode = estimate.modes[c];
    if (mode == before[c] || !plant_[component].modes[mode.index()].fault) continue;
    result.push_back(evidence_of(component, estimator, observation));
  }
  return result;
}

/// Of several faults that show at once, the likeliest story without one has none of them, and may be refuted by what
/// another one explains. So stories that fail without the component's doing are set aside, until one fails by it.
Evidence Explainer::evidence_of(automata::ComponentId component, const Estimator& estimator,
                                const automata::Observation& observation) {
  constexpr std::size_t stories = 32;  // so many faults at once are beyond what one line can explain
  if (!evidences_) evidences_.emplace(plant_);
  const Estimate& estimate = estimator.estimate();
  const automata::ModeId mode = estimate.modes[component.index()];
  std::optional<Evidence> first;
  std::vector<RefutedModes> aside;
  while (aside.size() < stories) {
    const auto story = estimator.likeliest_without(component, mode, aside);
    if (!story) break;
    Evidence evidence = evidences_->of(component, estimate.modes, *story, observation);
    if (evidence.kind == Evidence::Kind::outweighed) {
      const double rival = estimator.probability_of(*story);
      evidence.ratio = rival > 0 ? estimate.probability / rival : 0;
      return evidence;
    }
    if (std::find(evidence.modes.begin(), evidence.modes.end(), component) != evidence.modes.end()) return evidence;
    auto& modes = aside.emplace_back();
    for (const automata::ComponentId c : evidence.modes) modes.emplace_back(c, (*story)[c.index()]);
    if (!first) first = std::move(evidence);
  }
  if (first) return *first;
  return {component, mode, {}, Evidence::Kind::unavoidable, {}, {}, {}, 0};
}

}  // namespace rmpl::runtime
