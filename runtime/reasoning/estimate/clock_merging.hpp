// Keeps the distribution of clocks of a mode combination small: what differs least is merged, and what that can change
// is bounded.
//
// Two copies of a component that entered its mode at different times leave it by the same exits at different times.
// They can be coupled such that they part with a probability of at most the total variation distance of the times that
// are left. Each of our densities has a likelihood ratio of its residual times that crosses 1 once, so that this
// distance is the greatest difference of the two survivals (Scheffé; Shaked and Shanthikumar, Stochastic Orders, 1.C).
// Where a guard, or a transition that stays in the mode, may close an exit for a while, or other components may exclude
// an outcome so that the rest is scaled up, nothing less than 1 is known. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "automata/plant.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/combination.hpp"

namespace rmpl::runtime {

class ClockMerging {
 public:
  /// `excluding`, by component: whether others may exclude a mode of it. Keeps references.
  ClockMerging(const automata::Plant& plant, const Clocks& clocks, const std::vector<bool>& excluding)
      : plant_(plant), clocks_(clocks), excluding_(excluding) {}

  /// Merges clocks of a combination at `now` where they are more than `most` for each component that they tell apart;
  /// then to some fewer, so that not every step has to. Returns an upper bound of the probability, in the unit of the
  /// combination's, of all ways on that this changes.
  double limit(Combination& combination, std::size_t most, automata::Ticks now) const;
  /// An upper bound of the total variation distance between what a component in a mode does whose clock started at
  /// `a`, and at `b`.
  [[nodiscard]] double distance(std::size_t component, automata::ModeId mode, automata::Ticks a, automata::Ticks b,
                                automata::Ticks now) const;

 private:
  struct Pair;
  [[nodiscard]] std::vector<Pair> neighbours(const Combination& combination, const std::vector<std::size_t>& varied,
                                             automata::Ticks now) const;

  const automata::Plant& plant_;
  const Clocks& clocks_;
  const std::vector<bool>& excluding_;
};

}  // namespace rmpl::runtime
