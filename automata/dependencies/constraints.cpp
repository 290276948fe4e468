// The constraints of a plant, one by one.
// SPDX-License-Identifier: MIT
#include "automata/dependencies/constraints.hpp"

#include <utility>

namespace rmpl::automata {

std::vector<Constraint> constraints_of(const Plant& plant) {
  std::vector<Constraint> result;
  const auto tell = [&](std::optional<Assignment> under, const Formula& formula) {
    for (Formula& conjunct : conjuncts_of(formula)) {
      if (!conjunct.is_true()) result.push_back({under, std::move(conjunct)});
    }
  };
  for (const Interconnection& q : plant.interconnections) tell(std::nullopt, q.constraint);
  for (const Component& component : plant.components) {
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      tell(Assignment{component.mode, ValueId(m)}, component.modes[m].constraint);
    }
  }
  return result;
}

}  // namespace rmpl::automata
