// What one component may do in one step, and how long it lets time pass: semantics 3 and 7 as clock intervals.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/zone/time_model.hpp"
#include "verifier/zone/zone.hpp"

namespace rmpl::verifier {

/// Which ends of an interval exist at that one instant only: in cycles, however short, nothing is left of them.
struct Sharp {
  bool lower = false;
  bool upper = false;
  auto operator<=>(const Sharp&) const = default;
};

/// The readings of an interval that are left without the ends that exist at one instant only.
inline Interval lasting(Interval clock, const Sharp& sharp) {
  if (sharp.lower) ++clock.lower;
  if (sharp.upper) --clock.upper;
  return clock;
}

/// Going to `mode` (staying is going to its own mode) while the component's clock is within `clock`: in dense time at
/// the instant of the step, in sampled time at the end of its period.
struct Choice {
  automata::ModeId mode;
  unsigned faults = 0;  ///< 1 for a fault transition
  Interval clock;
  Sharp sharp = {};  ///< in dense time: an exit at its lower bound, staying at a bound that is reached
  auto operator<=>(const Choice&) const = default;
};

/// Every choice of a component in `mode` for which `enabled` tells what the guards allow; ordered, each once.
///
/// Faults first: one with time bounds only within them. They leave a nominal share while their probabilities sum to
/// less than 1. It goes to the untimed nominal transitions where there are any. Otherwise:
/// - dense: a timed exit may be taken from its lower bound on, and staying is possible, until an upper bound is passed
///   (its guard having become true late): the exit is then certain, in the first step in which it is enabled, and only
///   certain ones are possible. At the bound itself it is time that stops. A rate weighs nothing in an instant.
/// - sampled: an exit whose upper bound is reached at the end of the period is certain; beside one only certain ones
/// are
///   possible. Before that, staying is possible, and each exit whose bounds the period has entered.
/// A fault mode's transition to itself is staying there: no new fault.
std::vector<Choice> choices(const automata::Component& component, automata::ModeId mode,
                            const automata::Enabled& enabled, const TimeModel& time);

/// The readings, in whole units, at which there are faults alone, as they are certain.
std::vector<Interval> without_nominal(const std::vector<Choice>& choices);

/// Where the clock may be for time to pass with nothing changing, when `enabled` is what the guards allow all the
/// while: from the interval's lower bound on a wait may begin, at its upper bound it ends at the latest. Waits within
/// different intervals do not join up. In dense time: none at readings at which faults are certain, nor while an
/// untimed nominal transition to another mode is enabled, else up to the least upper bound of the enabled timed exits.
/// A transition to the same mode is staying: it stops no clock, and an untimed one leaves nothing to the timed exits
/// while it is enabled.
///
/// Of a component that restarts, the intervals are readings at which a wait of one unit at least may begin. Its clock
/// reads 0 from the first cycle on (in sampled time as each period begins), so that no upper bound ends the wait.
std::vector<Interval> waits(const automata::Component& component, automata::ModeId mode,
                            const automata::Enabled& enabled, const TimeModel& time);

/// The greatest constants that the clock of this mode is compared with, in lower bounds and in upper ones, by whatever
/// guards are enabled in it from some time on; `possible`, by mode, leaves out what is never gone to (none: all may
/// be).
ClockLimits clock_limits(const automata::Component& component, automata::ModeId mode, const TimeModel& time,
                         const std::vector<bool>& possible = {});

}  // namespace rmpl::verifier
