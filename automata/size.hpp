// How large a plant is, counted as Livingstone counts (its Table 1): components, modes, propositions, clauses.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "automata/plant.hpp"

namespace rmpl::automata {

struct PlantSize {
  std::size_t components = 0;
  std::size_t modes = 0;         ///< of all components
  std::size_t propositions = 0;  ///< x = v, for each variable and value, and for each mode once more in the next state
  /// Of the clausal form, multiplied out without auxiliary propositions: each variable has exactly one value (for modes
  /// in the next state too), the interconnections, each mode's constraint under its mode, and for each transition that
  /// its mode and guard imply a next mode.
  std::size_t clauses = 0;
};

PlantSize size_of(const Plant& plant);

}  // namespace rmpl::automata
