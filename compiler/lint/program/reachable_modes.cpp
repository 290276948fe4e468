// A fixpoint over the transitions of all components, each judged with the modes that the others have reached so far.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/reachable_modes.hpp"

#include <array>
#include <utility>

#include "automata/store/model.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Component;
using automata::Formula;
using automata::ValueId;

ReachableModes::ReachableModes(const automata::Plant& plant, const std::vector<Assignment>& also, MayHappen may)
    : plant_(plant), may_(may) {
  start(also);
  while (grow()) {
  }
}

bool ReachableModes::reached(Assignment mode) const {
  const auto component = plant_.component_of(mode.variable);
  return !component || reached_[component->index()][mode.value.index()];
}

void ReachableModes::start(const std::vector<Assignment>& also) {
  for (const Component& component : plant_.components) {
    auto& modes = reached_.emplace_back(component.modes.size(), false);
    for (std::size_t m = 0; m < modes.size(); ++m) modes[m] = component.initial[m] > 0;
  }
  for (const Assignment& mode : also) {
    if (const auto component = plant_.component_of(mode.variable)) {
      reached_[component->index()][mode.value.index()] = true;
    }
  }
}

Formula ReachableModes::formula() const {
  std::vector<Formula> conjuncts;
  for (std::size_t c = 0; c < reached_.size(); ++c) {
    std::vector<ValueId> modes;
    for (std::size_t m = 0; m < reached_[c].size(); ++m) {
      if (reached_[c][m]) modes.emplace_back(m);
    }
    if (modes.size() < reached_[c].size()) conjuncts.push_back(member(plant_.components[c].mode, std::move(modes)));
  }
  return conjunction(std::move(conjuncts));
}

std::vector<Formula> ReachableModes::by_cycle(const automata::Plant& plant, const std::vector<Assignment>& also) {
  ReachableModes modes(plant);
  modes.start(also);
  std::vector<Formula> result{modes.formula()};
  bool grows = modes.grow();
  result.push_back(modes.formula());
  while (grows) grows = modes.grow();
  result.push_back(modes.formula());
  return result;
}

bool ReachableModes::grow() {
  // A theory of its own for each round, that holds what is reached so far.
  automata::Theory theory = automata::model_theory(plant_, automata::Theory::Upkeep::searched);
  theory.tell(formula());
  for (const automata::Control& control : plant_.controls) {
    if (!may_.commands) theory.tell(is(control.variable, control.idle));
  }
  bool grown = false;
  const std::vector<std::vector<bool>> before = reached_;
  for (std::size_t c = 0; c < reached_.size(); ++c) {
    const Component& component = plant_.components[c];
    for (const automata::Transition& transition : component.transitions) {
      if (!before[c][transition.from.index()] || reached_[c][transition.to.index()]) continue;
      if (!may_.faults && component.is_fault(transition)) continue;
      const std::array from{Assignment{component.mode, ValueId(transition.from.index())}};
      if (!theory.allows(from, theory.encode(transition.guard))) continue;
      reached_[c][transition.to.index()] = true;
      grown = true;
    }
  }
  return grown;
}

std::vector<automata::Assignment> added_modes(const automata::Scenario& scenario, const automata::Plant& plant) {
  std::vector<automata::Assignment> also = scenario.truth;
  for (const automata::ForcedMode& forced : scenario.forced) {
    also.push_back({plant[forced.component].mode, automata::ValueId(forced.mode.index())});
    for (const automata::ModeId mode : forced.also) {
      also.push_back({plant[forced.component].mode, automata::ValueId(mode.index())});
    }
  }
  return also;
}

}  // namespace rmpl::compiler
