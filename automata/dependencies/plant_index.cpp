// What a variable of a plant is.
// SPDX-License-Identifier: MIT
#include "automata/dependencies/plant_index.hpp"

namespace rmpl::automata {

PlantIndex::PlantIndex(const Plant& plant)
    : component_of_(plant.variables.size()), control_of_(plant.variables.size()) {
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    component_of_[plant.components[c].mode.index()] = ComponentId(c);
  }
  for (std::size_t i = 0; i < plant.controls.size(); ++i) control_of_[plant.controls[i].variable.index()] = i;
}

}  // namespace rmpl::automata
