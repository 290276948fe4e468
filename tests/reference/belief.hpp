// Mode estimation by summing over everything: the twins of the exact and the k-best estimator (semantics 4).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "automata/state.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::reference {

/// The whole belief, by system state; states of probability 0 are left out.
using Belief = std::map<automata::SystemState, double>;

/// Clocks 0, the product of the initial distributions, impossible states dropped; not normalised.
Belief initial_belief(const Step& step);

/// All states that one step leads to, each with the summed probability of the ways there. Of the outcomes of each state
/// impossible ones are dropped, and the rest is scaled to 1.
Belief predicted(const Step& step, const Belief& belief, const automata::ControlAction& action, automata::Ticks before,
                 automata::Ticks now);

struct Update {
  Belief belief;
  automata::Observation set_aside;  ///< the first smallest set of readings without which some state explains the rest
  bool follows = true;              ///< false: no state does; `belief` is the one before, and nothing counts
};

/// BeliefUpdate of Fig. 6-10, normalised at the end.
Update belief_update(const Step& step, const Belief& belief, const automata::ControlAction& action,
                     const automata::Observation& observation, automata::Ticks before, automata::Ticks now);

/// The most likely plant state, summed over clocks; `unique` where no other comes within a hair of it.
struct MostLikely {
  automata::Modes modes;
  double probability = 0;
  bool unique = true;
};
MostLikely most_likely(const Belief& belief);

/// TimedME of Fig. 6-11: f of the best single trajectory into each system state that is consistent with the
/// observation, not summed, not weighted by the observation, not normalised. All of them; see `best`.
Belief timed_me(const Step& step, const Belief& belief, const automata::ControlAction& action,
                const automata::Observation& observation, automata::Ticks before, automata::Ticks now);

/// Ranks of system states: the exponents of the nearest powers of ten, added up along the best trajectory into each
/// state that is consistent with the observation.
using Ranks = std::map<automata::SystemState, std::uint64_t>;
Ranks initial_ranks(const Step& step);
Ranks ranked(const Step& step, const Ranks& ranks, const automata::ControlAction& action,
             const automata::Observation& observation, automata::Ticks before, automata::Ticks now);
/// The k best states and all that are as good as the k-th.
Ranks best(const Ranks& ranks, std::size_t k);

/// The k most probable entries, ties to the first in order of modes, then clocks. `clear` is false where the last
/// that was kept and the first that was not are too close for floating point to tell.
struct Best {
  Belief belief;
  bool clear = true;
};
Best best(const Belief& belief, std::size_t k);

}  // namespace rmpl::reference
