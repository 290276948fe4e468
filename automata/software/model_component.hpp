// Model programs as components of a plant, as the text gives them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/phca.hpp"
#include "automata/plant.hpp"

namespace rmpl::automata {

/// A model program as a component: its formulas are over the variables of the plant, its own are not used.
struct ModelComponent {
  std::string name;  ///< instance path; empty where the plant is the program alone
  ModelProgram program;
};

/// A plant with the model programs that it holds, as it is before its threads become components.
struct PlantWithModels {
  Plant plant;  ///< its components alone, with the variables and interconnections of all
  std::vector<ModelComponent> models;
};

}  // namespace rmpl::automata
