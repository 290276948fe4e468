// The closed loop of a program, a plant and a reconfigurer, state by state and tick by tick: the twin of
// verifier/program in both readings of time (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "automata/program.hpp"
#include "tests/reference/sequencer.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::reference {

/// What the reconfigurer says to modes and goal.
struct Advice {
  bool no_plan = false;
  automata::ControlAction action;
};
using Adviser = std::function<Advice(const automata::Modes&, const std::vector<automata::Assignment>&)>;

struct LoopQuestion {
  std::size_t faults = 0;
  std::optional<automata::Ticks> period;  ///< none: dense time, in steps of 1 s, of which all bounds are multiples
  automata::Formula formula;              ///< asked of all modes that are met
  automata::Ticks within;
};

/// What the loop can come to.
struct LoopAnswer {
  bool too_many = false;  ///< states, to say anything
  bool conflict = false;
  bool no_plan = false;
  bool holds = false;         ///< the store allows the formula, while the program runs or as it ends
  bool ends_without = false;  ///< the store need not imply it where the program ends
  bool late = false;          ///< nor at any time up to `within`
  bool waits_for_ever = false;
  bool runs_for_ever = false;  ///< waiting or not
};

/// Every state is a point: whole units on each clock. In dense time a cycle sees a clock that reads n as a little less
/// than n, as n, or as a little more; as time goes by only more, and a clock that was started in an earlier cycle ahead
/// of one that was started later. A run for ever is a cycle of states on which time passes, and on which no component
/// could leave its mode all the while and does not.
LoopAnswer explore_loop(const automata::Program& program, const Step& step, const Adviser& adviser,
                        const LoopQuestion& question);

}  // namespace rmpl::reference
