// Minimal cut sets: all smallest sets of faults that lead to what is looked for.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "base/function_ref.hpp"
#include "verifier/cut_set/fault_sets.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/search/search.hpp"

namespace rmpl::verifier {

/// A set of faults with a path that has them and no others.
struct CutPath {
  FaultSet set;
  std::vector<PathState> path;
  SymbolicState end;  ///< the accepted state
};

/// As many as an exploration has come to know.
struct CutPaths {
  std::vector<FaultSet> sets;  ///< minimal, whatever was not explored; sorted by size, then by component and mode
  std::optional<Limit> limit;  ///< which ended the exploration; none: these are all
};

/// Every minimal set of faults of the runs to an accepted state, within the system's budget. One exploration: a state
/// covers another that has had a superset of its faults, and what has had a superset of a set that was found is not
/// followed. The system counts faults by these sets; its states hold their numbers.
///
/// Fewest faults come first, so that a limit leaves minimal sets that are known to be (M. Bozzano, A. Cimatti,
/// A. Griggio, C. Mattarei: Efficient Anytime Techniques for Model-Based Safety Analysis, 2015): those of which no
/// state that is yet to be explored has had a proper subset, as a smaller set can only be found by going on from there.
///
/// Each set is shown to `found` first, whether it turns out to be minimal or not; where that answers false the
/// exploration ends, and what it has found is of no use. What is thrown there counts as a limit that was hit before.
CutPaths minimal_cut_sets(TransitionSystem& system, const FaultSets& sets, Meter& meter,
                          base::FunctionRef<bool(const CutPath&)> found);

}  // namespace rmpl::verifier
