// Where a Markov chain comes to in the end, and after how long: by elimination of states.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "verifier/markov/decision_process.hpp"

namespace rmpl::verifier {

/// What becomes of runs from a state.
struct Fate {
  Enclosure wanted;   ///< the probability of coming to what is wanted
  Enclosure unknown;  ///< of coming to what is left out
  Enclosure lost;     ///< of anything else
  Enclosure time;     ///< the mean of the time in states until one of the former two
};

/// By state, for a chain. `times`, by state, is the mean time that each visit takes; empty: 1 each. In each strongly
/// connected component states are taken out one after the other, with what leads through them added up; terms are from
/// 0, and nothing is subtracted, so that each result has a small relative error (W. Grassmann, M. Taksar, D. Heyman:
/// Regenerative analysis and steady state distributions for Markov chains, 1985). Cost: cubic in the size of a
/// component at worst; linear where there are no cycles. Polls.
std::vector<Fate> fates(const DecisionProcess& chain, const std::vector<Enclosure>& times, Meter& meter);

}  // namespace rmpl::verifier
