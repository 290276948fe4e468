// The plant model as a constraint store.
// SPDX-License-Identifier: MIT
#include "automata/store/model.hpp"

namespace rmpl::automata {

void tell_model(Theory& theory, const Plant& plant) {
  for (const Interconnection& q : plant.interconnections) theory.tell(q.constraint);
  for (const Component& component : plant.components) {
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const Formula& constraint = component.modes[m].constraint;
      if (!constraint.is_true()) theory.tell_if({component.mode, ValueId(m)}, constraint);
    }
  }
}

Theory model_theory(const Plant& plant, Theory::Upkeep upkeep) {
  Theory theory(plant.variables, upkeep);
  tell_model(theory, plant);
  return theory;
}

}  // namespace rmpl::automata
