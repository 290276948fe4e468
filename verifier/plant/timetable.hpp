// Timetables: concrete times for a symbolic path of a plant.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/plant/plant_system.hpp"
#include "verifier/search/search.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// The run with the earliest times of a path of the system to an accepted state.
Witness earliest_witness(const std::vector<PathState>& path, PlantSystem& system);

}  // namespace rmpl::verifier
