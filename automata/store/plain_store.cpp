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

bool PlainStore::implies_guard(ComponentId component, TransitionId transition, const Modes& modes,
                               const ControlAction& action) {
  return theory_.entails(assumptions(plant_, modes, assignments_of(plant_, action)),
                         guards_[component.index()][transition.index()]);
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
