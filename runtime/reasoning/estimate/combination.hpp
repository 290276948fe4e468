// Beliefs by mode combination: for each, the clocks as a distribution.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "automata/state.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

/// When the clocks started, with what that is worth.
struct Clocked {
  std::vector<automata::Ticks> starts;  ///< by component
  double probability = 0;
  bool operator==(const Clocked&) const = default;
};

/// One mode combination: its probability is the sum over its clocks, of which there is at least one.
struct Combination {
  automata::Modes modes;
  double probability = 0;
  std::vector<Clocked> clocks;
  bool operator==(const Combination&) const = default;
};

/// Most probable first; ties in order of modes, then of the first clocks.
using Combinations = std::vector<Combination>;

/// As `put_in_order` of beliefs, of combinations and of the clocks of each.
void put_in_order(Combinations& combinations);

/// The states of all combinations, in the order of `Belief`.
Belief states_of(const Combinations& combinations);

/// The combinations of a belief, in order.
Combinations combinations_of(const Belief& belief);

/// Makes `result` the components whose clocks are not the same in all of the combination, ascending; `clocks` are those
/// by which it was made.
void find_differing(const Combination& combination, const Clocks& clocks, std::vector<std::size_t>& result);

double total(const Combinations& combinations);

/// Multiplies all probabilities.
void scale(Combinations& combinations, double factor);

/// Divides all probabilities by the total, where that is positive.
void normalise(Combinations& combinations);

}  // namespace rmpl::runtime
