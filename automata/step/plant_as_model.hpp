// A plant as a model program: components that step without time, beside model programs, over one store (semantics 8).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "automata/phca.hpp"
#include "automata/plant.hpp"

namespace rmpl::automata {

/// A model program as a component: its formulas are over the variables of the plant, its own are not used.
struct ModelComponent {
  std::string name;  ///< instance path
  ModelProgram program;
};

/// A plant with the model programs that it holds, as it is before all of it becomes one model program.
struct PlantWithModels {
  Plant plant;  ///< its components alone, with the variables and interconnections of all
  std::vector<ModelComponent> models;
};

/// Why a component has no place in a model program, and what is to blame.
struct Obstacle {
  std::string reason;  ///< `the transition takes time`
  Origin origin;
};

/// A model program counts steps, which have no length: a transition with time bounds, and a fault with a rate, have no
/// place in it; nor has a mode that more than `most_guards` different guards lead out of.
inline constexpr std::size_t most_guards = 10;
std::optional<Obstacle> obstacle_to_model(const Component& component);

/// One location a mode, which tells the mode and its constraint; what the model programs have stays as it is, each in a
/// composite. The belief over such a program is that over the plant, as long as no command contradicts the model.
/// `components` and interconnections first, then the models, in their order. No component has an obstacle.
ModelProgram as_model_program(const Plant& plant, std::span<const ModelComponent> models);

}  // namespace rmpl::automata
