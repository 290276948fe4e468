// Minimal cut sets: all smallest sets of faults that lead to what is looked for.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "verifier/plant/fault_sets.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/search/search.hpp"

namespace rmpl::verifier {

/// A set of faults with a path that has them and no others.
struct CutPath {
  FaultSet set;
  std::vector<PathState> path;
  SymbolicState end;  ///< the accepted state
};

/// Every minimal set of faults of the runs to an accepted state, within the system's budget; sorted by size, then by
/// component and mode. One exploration: a state covers another that has had a superset of its faults, and what has had
/// a superset of a set that was found is not followed. The system counts faults by these sets; its states hold their
/// numbers. Throws LimitReached.
std::vector<CutPath> minimal_cut_sets(TransitionSystem& system, const FaultSets& sets, Meter& meter);

}  // namespace rmpl::verifier
