// Breadth-first search with inclusion checking.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "verifier/explore/limits.hpp"
#include "verifier/explore/system.hpp"

namespace verifier {

/// One state on the way to an accepted one, with the label that led to it.
struct PathState {
  std::uint64_t discrete;
  Label label;
};

/// What is wanted of a path.
enum class SearchOrder {
  fewest_steps,
  any  ///< covered states need not be explored
};

/// A path to an accepted state; nothing where the whole system holds none. Throws LimitReached.
///
/// A state is left out where one that was found before covers it: same discrete part, no more faults, a zone that can
/// do all that its zone can. States are explored in order of steps, those that a silent label leads to with the state
/// they come from.
std::optional<std::vector<PathState>> find_path(TransitionSystem& system, SearchOrder order, Meter& meter);

inline std::optional<std::vector<PathState>> shortest_path(TransitionSystem& system, Meter& meter) {
  return find_path(system, SearchOrder::fewest_steps, meter);
}

}  // namespace verifier
