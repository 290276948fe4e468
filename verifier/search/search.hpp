// Breadth-first search with inclusion checking.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "verifier/search/limits.hpp"
#include "verifier/search/passed.hpp"

namespace rmpl::verifier {

/// In which order states are explored.
enum class SearchOrder {
  fewest_steps,  ///< in order of steps: the path has fewest
  covering,      ///< fewest faults first, then the least rank; covered states are not explored
  merging        ///< the same, states that wait being put together; see find_corridor
};

/// A path to an accepted state; nothing where the whole system holds none. Throws LimitReached.
///
/// A state is left out where one that was found before covers it: same discrete part, no more faults, a zone that can
/// do all that its zone can. A state that a silent label leads to is explored with the state it comes from.
std::optional<std::vector<PathState>> find_path(TransitionSystem& system, SearchOrder order, Meter& meter);

/// Whether there is such a path, found by fewer states: before a state is explored it takes in those with the same
/// discrete part that wait, where the zone of all together holds nothing that has not been found. What is explored so
/// is reachable, reading by reading (on whole units, which decide); but a state has come about in several ways, and a
/// path is looked for among them, on another day. Nothing where the whole system holds no accepted state.
std::optional<Corridor> find_corridor(TransitionSystem& system, Meter& meter);

/// A path to an accepted state that keeps to a corridor, where there is one. States were counted when the corridor was
/// found. Throws LimitReached.
std::optional<std::vector<PathState>> find_path_along(const Corridor& corridor, TransitionSystem& system, Meter& meter);

}  // namespace rmpl::verifier
