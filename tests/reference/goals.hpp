// Goal states and plans by looking at all of them: the twins of runtime/reconfigure (semantics 5; thesis 6.3).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "automata/state.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::reference {

/// Per component, the modes that the goal interpreter may choose: those it reaches by nominal transitions that are
/// timed, reversible, repairs of its mode, or lead to a mode that the goal names: assigns outside negations. A
/// transition counts only where some consistent state and control action imply its guard, by modes that the other
/// components reach.
std::vector<std::set<automata::ModeId>> reachable_modes(const Step& step, const automata::Modes& modes,
                                                        const automata::Formula& goal);

struct GoalState {
  automata::Modes modes;
  double reward = 0;
};

/// Over the reachable modes of each component: the state that is consistent, entails the goal, and has the greatest
/// summed reward; of several the one that is first in declaration order. Nothing where there is none.
std::optional<GoalState> best_goal_state(const Step& step, const automata::Modes& modes, const automata::Formula& goal);

/// Every state that one nominal step may lead to: timed exits may fire or not.
std::set<automata::Modes> nominal_successors(const Step& step, const automata::Modes& modes,
                                             const automata::ControlAction& action);

/// The cheapest control action that is enough in one step: in every one of the states it agrees with the store, takes
/// no step of its own that cannot be undone and is not named, leads each component to modes only that the goal's
/// conjuncts over it permit, and every one of at least one possible nominal successor entails the goal. Cheapest:
/// fewest controls off idle, then the first by values. Nothing where there is none.
std::optional<automata::ControlAction> cheapest_action(const Step& step, const std::vector<automata::Modes>& states,
                                                       const automata::Formula& goal);

/// Every state in which a nominal execution of the commands, one a step, may end.
std::set<automata::Modes> nominal_outcomes(const Step& step, const automata::Modes& modes,
                                           const std::vector<automata::ControlAction>& commands);

/// The fewest control actions, idle or one control off idle, that lead from one state to another through states in
/// which nothing happens of itself, by steps with one outcome that every component can undo. Nothing where there are
/// none.
std::optional<std::vector<automata::ControlAction>> shortest_reversible_plan(const Step& step,
                                                                             const automata::Modes& from,
                                                                             const automata::Modes& to);

}  // namespace rmpl::reference
