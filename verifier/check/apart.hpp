// Parts that have nothing to do with each other, each asked by itself what would else be asked of all of them.
// SPDX-License-Identifier: MIT
#pragma once

#include "verifier/check/search_scope.hpp"
#include "verifier/slice/slices.hpp"

namespace rmpl::verifier {

/// Components that no guard and no constraint connects with others.
struct ConnectedPart {
  std::vector<automata::Formula> formulas;  ///< each reads the mode of one of them
  Cone cone;                                ///< all of them
};

/// Whether a component is in both.
bool meet(const Cone& a, const Cone& b);

/// Every component is in one of them.
std::vector<ConnectedPart> connected_parts(Slices& slices);

/// Whether the part can go on by itself from each state that it comes to, all of its controls idle, and no fault of it
/// can be certain, which would make the budget of all matter. Throws LimitReached.
bool goes_on_by_itself(Slices& slices, const ConnectedPart& part, const SearchScope::Terms& terms);

/// Whether the plant falls into parts that no guard and no constraint connects, each of which can go on by itself from
/// each state that it comes to, all of its controls idle: then so can the plant, all controls idle. Sufficient; false
/// too where the plant is one part, or a fault can be certain, so that the budget of all matters. Throws LimitReached.
bool each_goes_on(Slices& slices, const SearchScope::Terms& terms);

/// Whether the response comes in time after what is asked of the part alone that it is in, so that it does whatever
/// else is asked at the same time. Sufficient; false too where that part is not much smaller. Throws LimitReached.
bool comes_in_its_part(Slices& slices, const Response& response, const SearchScope::Terms& terms);

}  // namespace rmpl::verifier
