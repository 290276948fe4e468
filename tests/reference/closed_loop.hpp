// The closed loop of a program, a plant and a reconfigurer, state by state and tick by tick: the twin of
// verifier/program in both readings of time (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "automata/program.hpp"
#include "tests/reference/executive.hpp"
#include "tests/reference/sequencer.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::reference {

/// What a reconfigurer says, and what it knows besides, as a number: 0 where that is nothing.
struct Adviser {
  using Position = std::size_t;
  std::function<Advice(const automata::Modes&, const std::vector<automata::Assignment>& goal, Position)> says;
  /// What it knows when what it said has led to modes.
  std::function<Position(const automata::Modes&, const std::vector<automata::Assignment>& goal, Position,
                         const automata::Modes& then)>
      knows;
};

struct LoopQuestion {
  std::size_t faults = 0;
  std::optional<automata::Ticks> period;                  ///< none: dense time, in steps of `unit`
  automata::Ticks unit = automata::Ticks::of_seconds(1);  ///< all bounds are multiples of it
  automata::Formula formula;                              ///< asked of all modes that are met
  automata::Formula then = automata::constant(true);      ///< asked for each time `formula` holds
  automata::Ticks within;                                 ///< of `formula` from the start, of `then` from there on
  /// The fault modes, by component, that may be gone into; any, where it is empty.
  std::optional<std::set<std::pair<std::size_t, automata::ModeId>>> faults_allowed = std::nullopt;
};

/// What the loop can come to.
struct LoopAnswer {
  bool too_many = false;  ///< states, to say anything
  bool conflict = false;
  bool no_plan = false;
  bool undone = false;          ///< a command for reward takes a component out of a mode that a goal achieved
  bool holds = false;           ///< the store allows the formula, while the program runs or as it ends
  bool ends_without = false;    ///< the store need not imply it where the program ends
  bool late = false;            ///< nor at any time up to `within`
  bool missed = false;          ///< it allows the formula while the program runs, and does not imply `then` in time
  bool never_comes = false;     ///< on some run the store never implies the formula
  bool never_answered = false;  ///< nor, on some run, `then` from where it allows the formula while the program runs
  bool waits_for_ever = false;
  bool runs_for_ever = false;  ///< waiting or not
  bool stops = false;          ///< while the program runs it comes to where, but for faults, time never passes again
};

/// Every state is a point: whole units on each clock. In dense time a cycle sees a clock that reads n as a little less
/// than n, as n, or as a little more; as time goes by only more, and a clock that was started in an earlier cycle ahead
/// of one that was started later. Runs for ever, and states that cannot be left: endless.hpp. To find the latter in
/// dense time, halves of the greatest unit are needed: where a bound has passed and the next has not come yet, fewer
/// steps are possible than at either.
LoopAnswer explore_loop(const automata::Program& program, const Step& step, const Adviser& adviser,
                        const LoopQuestion& question);

}  // namespace rmpl::reference
