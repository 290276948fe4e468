// The shared part of the findings about a plant.
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/analysis.hpp"

#include <algorithm>

#include "automata/step/transition_rules.hpp"

namespace rmpl::compiler {

using automata::ComponentId;

PlantAnalysis::PlantAnalysis(const automata::Plant& plant)
    : plant_(plant),
      index_(plant),
      observed_(plant.variables.size()),
      readers_(plant.variables.size()),
      islands_(plant.components.size()),
      questions_(plant),
      is_possible_(questions_.possible({})) {
  if (is_possible_) reach_ = reach_of(questions_);
  for (const automata::VariableId v : plant.observables) observed_[v.index()] = true;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    instances_[plant.components[c].type].emplace_back(c);
  }
  const auto& islands = locality().islands();
  constexpr std::size_t work = 8192, least = 8, most = 64;
  for (std::size_t i = 0; i < islands.size(); ++i) {
    patience_.push_back(std::clamp(work / (1 + islands[i].attributes.size()), least, most));
    for (const ComponentId c : islands[i].support.components) islands_[c.index()].push_back(i);
  }
  if (is_possible_) collect_readers();
}

bool PlantAnalysis::can_happen(PlantTransition transition) const {
  const std::size_t c = transition.component.index();
  const automata::Transition& t = plant_.components[c].transitions[transition.transition.index()];
  return reach_.reached[c][t.from.index()] && can_ever_be_taken(t) &&
         reach_.guards[c][transition.transition.index()].verdict != Implied::Verdict::no;
}

void PlantAnalysis::collect_readers() {
  for (std::size_t c = 0; c < plant_.components.size(); ++c) {
    const auto& transitions = plant_.components[c].transitions;
    for (std::size_t t = 0; t < transitions.size(); ++t) {
      const PlantTransition transition{ComponentId(c), automata::TransitionId(t)};
      if (!can_happen(transition)) continue;
      for (const automata::VariableId v : variables_of(transitions[t].guard)) {
        readers_[v.index()].push_back(transition);
      }
    }
  }
}

Blame& PlantAnalysis::blame() {
  if (!blame_) blame_ = std::make_unique<Blame>(plant_, reach_.reached);
  return *blame_;
}

Blame& PlantAnalysis::blame_at_large() {
  if (!blame_at_large_) blame_at_large_ = std::make_unique<Blame>(plant_, all_modes(plant_));
  return *blame_at_large_;
}

}  // namespace rmpl::compiler
