// Reachability by explicit search, tick by tick: the twin of verifier/ in both readings of time (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "automata/logic/formula.hpp"
#include "automata/time/time.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::reference {

/// Whenever `after` holds, `then` is to hold at some time at most `within` later.
struct Response {
  automata::Formula after;
  automata::Formula then;
  automata::Ticks within;    ///< infinite: some day
  bool stuck_misses = true;  ///< what is owed where nothing can follow is missed where what follows would come too late
};

struct Question {
  automata::Formula target;          ///< what is looked for
  std::optional<Response> response;  ///< in its place: a response that is missed
  bool entailed = false;   ///< the store implies a formula, not only allows it; refutes `then`, not only leaves it open
  std::size_t faults = 0;  ///< budget
  enum class Commands { none, one, any } commands = Commands::one;
};

/// The fewest steps in which some mode changes that lead to the target; nothing where it is out of reach.
/// Sampled time: one step a `period`, possible is what semantics 3 gives a positive probability.
std::optional<std::size_t> fewest_steps_sampled(const Step& step, const Question& question, automata::Ticks period);

/// The same in dense time, by search on the grid of `unit`, which every finite bound of the plant must be a multiple
/// of. The grid is exact: all conditions of semantics 7 on clocks (lower <= clock, clock <= upper) are closed with
/// integer bounds, and clocks restart at 0, so that by the digitization theorem of Henzinger, Manna and Pnueli (What
/// good are digital clocks?, ICALP 1992) rounding the times of a run down to whole units gives a run with the same
/// steps.
std::optional<std::size_t> fewest_steps_dense(const Step& step, const Question& question, automata::Ticks unit);

/// Whether some run owes the response of the question, whose time is infinite, and never gives it: it gets stuck so, or
/// goes on for ever, by the rules of `runs_for_ever` (endless.hpp). Dense (no period) on the grid of `unit`, as below.
bool never_answers(const Step& step, const Question& question, std::optional<automata::Ticks> period,
                   automata::Ticks unit);

/// Whether from some reachable state on nothing can follow, or time stands still: steps without a fault never take time
/// again. In dense time (no period) on the grid of `unit`, of which every finite bound is an even multiple: where a
/// bound has passed and the next has not come yet, fewer steps are possible than at either. A state in which a fault is
/// certain is not judged.
bool comes_to_a_stop(const Step& step, const Question& question, std::optional<automata::Ticks> period,
                     automata::Ticks unit);

/// Whether in some reachable state more faults are certain than there may be.
bool exceeds_faults(const Step& step, const Question& question, std::optional<automata::Ticks> period,
                    automata::Ticks unit);

}  // namespace rmpl::reference
