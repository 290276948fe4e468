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
  covering       ///< fewest faults first, then fewest steps; covered states are not explored
};

/// A path to an accepted state; nothing where the whole system holds none. Throws LimitReached.
///
/// A state is left out where one that was found before covers it: same discrete part, no more faults, a zone that can
/// do all that its zone can. A state that a silent label leads to is explored with the state it comes from. The result
/// does not depend on the number of `threads`, 1 or more, that work out successors.
std::optional<std::vector<PathState>> find_path(TransitionSystem& system, SearchOrder order, unsigned threads,
                                                Meter& meter);

}  // namespace rmpl::verifier
