// Which components of a plant are software.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "automata/plant.hpp"

namespace rmpl::automata {

/// The first component that is software; null where there is none.
inline const Component* software_in(const Plant& plant) {
  const auto found = std::find_if(plant.components.begin(), plant.components.end(),
                                  [](const Component& component) { return component.software; });
  return found == plant.components.end() ? nullptr : &*found;
}

/// Whether there is nothing else.
inline bool is_software_alone(const Plant& plant) {
  return std::all_of(plant.components.begin(), plant.components.end(),
                     [](const Component& component) { return component.software; });
}

}  // namespace rmpl::automata
