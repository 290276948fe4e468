// The store of a plant, plainly.
// SPDX-License-Identifier: MIT
#include "automata/store/plain_store.hpp"

#include "automata/store/model.hpp"

namespace rmpl::automata {
namespace {

std::vector<Assignment> assumptions(const Plant& plant, const Modes& modes, const std::vector<Assignment>& more = {}) {
  std::vector<Assignment> result = assignments_of(plant, modes);
  result.insert(result.end(), more.begin(), more.end());
  return result;
}

}  // namespace

PlainStore::PlainStore(const Plant& plant) : plant_(plant), theory_(model_theory(plant, Theory::Upkeep::searched)) {
  for (const Component& component : plant.components) {
    auto& handles = guards_.emplace_back();
    for (const Transition& t : component.transitions) handles.push_back(theory_.encode(t.guard));
  }
}

bool PlainStore::possible(const Modes& modes) { return theory_.consistent(assumptions(plant_, modes)); }

bool PlainStore::consistent(const Modes& modes, const ControlAction& action) {
  return theory_.consistent(assumptions(plant_, modes, assignments_of(plant_, action)));
}

std::vector<std::vector<bool>> PlainStore::implied_guards(const Modes& modes, const ControlAction& action) {
  const std::vector<Assignment> store = assumptions(plant_, modes, assignments_of(plant_, action));
  // What is false in one model of the store is not implied: that saves most questions.
  const bool consistent = theory_.consistent(store);
  std::vector<std::vector<bool>> result;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    auto& own = result.emplace_back();
    for (std::size_t t = 0; t < guards_[c].size(); ++t) {
      const bool starts_here = plant_.components[c].transitions[t].from == modes[c];
      own.push_back(starts_here && (!consistent || theory_.holds(guards_[c][t])));
    }
  }
  for (std::size_t c = 0; c < modes.size(); ++c) {
    for (std::size_t t = 0; t < guards_[c].size(); ++t) {
      if (!result[c][t] || plant_.components[c].transitions[t].guard.is_true()) continue;
      result[c][t] = theory_.entails(store, guards_[c][t]);
    }
  }
  return result;
}

bool PlainStore::implies(const Formula& formula, const Modes& modes) {
  return theory_.entails(assumptions(plant_, modes), theory_.encode(formula));
}

bool PlainStore::allows(const Formula& formula, const Modes& modes) {
  return theory_.allows(assumptions(plant_, modes), theory_.encode(formula));
}

bool PlainStore::explains(const Modes& modes, const Observation& observation) {
  return theory_.consistent(assumptions(plant_, modes, observation));
}

}  // namespace rmpl::automata
