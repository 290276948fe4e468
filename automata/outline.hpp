// What a plant is made of: types, each once, and their instances, found again in the flat plant by the names.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "automata/plant.hpp"

namespace rmpl::automata {

/// An instance of a type, as `instantiate` makes it.
struct PlantInstance {
  std::string name;
  std::size_t type = 0;  ///< its position in `PlantOutline::types`
  /// Of a type with one component: where the instance starts, if that is not as the type does.
  std::optional<std::vector<double>> initial;
  bool progress = false;  ///< likewise: its steps need no licence, and those of the type do
};

/// A plant, or a type, put together: its own variables and components first, then its instances, one after the other,
/// then its own interconnections, controls and observables.
struct PlantParts {
  std::size_t variables = 0;         ///< its own, the first so many
  std::size_t components = 0;        ///< its own, the first so many
  std::size_t interconnections = 0;  ///< where its own begin
  std::size_t controls = 0;          ///< where its own begin
  std::size_t observables = 0;       ///< where its own begin
  std::vector<PlantInstance> instances;
};

/// Something with instances.
struct PlantType {
  std::string name;  ///< of the component type, of a module that of the first instance; with a number where it is taken
  Plant plant;       ///< flat, names relative to the type; what bears the name of the instance is named ""
  PlantParts parts;
};

struct PlantOutline {
  std::vector<PlantType> types;  ///< each before those that have instances of it; all different
  PlantParts whole;
};

/// The instances of a plant: neighbours whose names begin alike and that speak of nothing else, and within them again.
/// What a source made of modules and component types is found as it was, but that what is said of the last instance
/// alone goes with it; where the order is not such that a plant comes about so, all that is in it is its own. Linear in
/// the plant, times the depth of its names.
PlantOutline outline_of(const Plant& plant);

}  // namespace rmpl::automata
