// Timetables: concrete times for a symbolic path of a plant.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/plant/plant_system.hpp"
#include "verifier/search/search.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// A run along a path, and which of its events each state of the path is entered with.
struct TimedPath {
  Witness witness;
  std::vector<std::size_t> entered;
};
/// The run with the earliest times.
TimedPath earliest_path(const std::vector<PathState>& path, PlantSystem& system);
/// The same of a path to an accepted state.
Witness earliest_witness(const std::vector<PathState>& path, PlantSystem& system);

}  // namespace rmpl::verifier
