// Islands that nothing contradicts.
// SPDX-License-Identifier: MIT
#include "automata/store/totality.hpp"

#include <algorithm>

#include "automata/store/elimination.hpp"

namespace rmpl::automata {

bool is_total(const Plant& plant, const Island& island) {
  std::vector<VariableId> free = island.attributes;
  const std::vector<std::size_t>& controls = island.support.controls;
  std::erase_if(free, [&](VariableId v) {
    return std::any_of(controls.begin(), controls.end(),
                       [&](std::size_t control) { return plant.controls[control].variable == v; });
  });
  return Elimination(plant.variables, island.constraints, free).left().empty();
}

}  // namespace rmpl::automata
