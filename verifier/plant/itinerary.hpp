// Itineraries: a symbolic path told in the names of the plant, whatever symmetry the search made use of.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "verifier/plant/plant_system.hpp"
#include "verifier/search/search.hpp"

namespace rmpl::verifier {

/// One state of a path, and how it is come to.
struct Leg {
  automata::Modes modes;
  Phase phase;
  std::optional<JointStep> move;                      ///< into this state; none for the first one
  std::optional<Box> wait;                            ///< within which time passes in it; none where it does not
  std::vector<automata::ComponentId> restarted = {};  ///< whose clocks restart in that wait
  std::optional<Box> end;                             ///< where a run is cut off in the last one: within which it is
  Phase cut_off = Phase::searching;                   ///< and how
  bool progressed = false;                            ///< time passed before the move, where that is watched
};

/// The path without symmetry. Each state that was explored stands for one that a permutation leads to: the permutations
/// are worked out again step by step, and their product is undone.
std::vector<Leg> itinerary(const std::vector<PathState>& path, PlantSystem& system);

}  // namespace rmpl::verifier
