// Islands that nothing contradicts.
// SPDX-License-Identifier: MIT
#include "automata/store/totality.hpp"

#include <algorithm>

#include "automata/store/elimination.hpp"

namespace rmpl::automata {

bool is_total(const Plant& plant, const Island& island) {
  std::vector<VariableId> free = island.attributes;
  std::erase_if(free, [&](VariableId v) {
    return std::any_of(plant.controls.begin(), plant.controls.end(), [&](const Control& c) { return c.variable == v; });
  });
  return Elimination(plant.variables, island.constraints, free).left().empty();
}

}  // namespace rmpl::automata
