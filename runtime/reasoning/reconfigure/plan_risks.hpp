// Where time may undo a plan before it is done.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/plan.hpp"
#include "runtime/reasoning/reconfigure/reason.hpp"

namespace rmpl::runtime {

/// A wait, be it with a command in force, and a component that may leave its mode meanwhile, by a timed transition with
/// an upper bound, so that the rest of the plan does not lead to the goal any more: it rested on that mode, or on what
/// this takes with it. Whether it is in time depends on durations, which no plan compares. Or one that leaves at once,
/// by an untimed transition, a mode without which what is waited for does not come.
struct PlanRisk {
  std::size_t wait;  ///< position among the commands
  TransitionOf leaving;
};

/// In order of waits, what leaves at once first, then components; of each component the first such transition.
std::vector<PlanRisk> risks_of(const Plan& plan, automata::PlantStep& step, const automata::Formula& goal);

/// Where the goal state does not last: the untimed transitions that take the goal away at once, all controls idle, one
/// a component. The executive would bring it about again, and again.
std::vector<TransitionOf> lost_in_the_end(const Plan& plan, automata::PlantStep& step, const automata::Formula& goal);

}  // namespace rmpl::runtime
