// A whole plan: what reconfiguration would command, cycle by cycle, if nothing failed.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/state.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

struct Plan {
  enum class Outcome { plan, no_plan, nothing_to_do };
  Outcome outcome = Outcome::nothing_to_do;
  /// With `plan` and `nothing_to_do`: where it ends. With `no_plan`: the one that was aimed at, if any.
  std::optional<automata::Modes> goal_state;
  std::vector<automata::ControlAction> commands;   ///< with `plan`: at least one; idle means to wait
  std::vector<automata::Modes> states;             ///< with `plan`: before each command, and in the end
  std::optional<automata::ComponentId> component;  ///< with `no_plan`: the one to blame, where there is one
  std::string reason;                              ///< with `no_plan`: in words
  Reason why;                                      ///< with `no_plan`: as data
  bool sure = true;                                ///< of all answers: what may come meanwhile is provided for
  bool bounds_counted = true;                      ///< of all answers
  bool proved_best = true;                         ///< of all answers
};

/// Asks `reconfigurer` again and again, from `modes` on, moving to the state that each answer expects. A wait is one
/// step, however long it lasts: in it the transition that is waited for happens (`Reconfiguration::component`), and no
/// other timed one, so that an event which the plan does not depend on, and which may be hours away, does not intrude.
/// Where a state comes again, or nothing leads back to a goal that was lost by itself, it ends where the goal was
/// entailed last, and with `no_plan` where it never was.
Plan make_plan(const automata::Plant& plant, Reconfigurer& reconfigurer, const automata::Modes& modes,
               const automata::Formula& goal);

/// The plan of a reconfigurer whose one answer is to be enough (one_step.hpp): asked once, so that it does not matter
/// whether the state that is reached can be kept.
Plan make_one_step_plan(Reconfigurer& reconfigurer, const automata::Modes& modes, const automata::Formula& goal);

}  // namespace rmpl::runtime
