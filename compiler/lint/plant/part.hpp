// A part of a plant as a plant of its own: components that have something to do with each other, and with no other.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/plant.hpp"

namespace rmpl::compiler {

struct PlantPart {
  automata::Plant plant;
  std::vector<automata::ComponentId> components;  ///< in the whole, by position in the part
  std::vector<automata::VariableId> variables;    ///< in the whole, by position in the part
};

/// The parts (`Dependencies::parts`) that hold components, in order of their first variables.
std::vector<PlantPart> parts_of(const automata::Plant& plant);

}  // namespace rmpl::compiler
