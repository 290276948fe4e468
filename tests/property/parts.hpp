// Parts that contradict each other, told to a solver of their own.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"

namespace rmpl::property {

/// Whether all parts but the one `without` (past the end: all of them) can hold together.
inline bool consistent(const automata::Plant& plant, const std::vector<automata::Formula>& parts, std::size_t without) {
  automata::Theory fresh(plant.variables);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i != without) fresh.tell(parts[i]);
  }
  return fresh.consistent({});
}

}  // namespace rmpl::property
