// Goal states and plans by looking at all of them: the twins of runtime/reconfigure (semantics 5; thesis 6.3).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "automata/state.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::reference {

/// Every combination of values of the controls.
std::vector<automata::ControlAction> all_actions(const automata::Plant& plant);

/// Every combination of modes, possible or not.
std::vector<automata::Modes> all_states(const automata::Plant& plant);

/// Whether at most one control is off its idle value.
bool is_single(const automata::Plant& plant, const automata::ControlAction& action);

/// Whether a transition has a weight with which it is taken at all.
bool can_be_taken(const automata::Transition& t);

/// The modes of a component that a goal names: atoms under an even number of negations, an antecedent counting as one;
/// an inequality and an equivalence name none.
std::set<automata::ModeId> named_modes(const automata::Plant& plant, std::size_t component,
                                       const automata::Formula& goal);

/// A step that must not be taken by command: a nominal transition, from no fault, without a way back by nominal
/// transitions, whose target leads to no mode of its component that the goal names.
bool is_forbidden(const Step& step, std::size_t component, const automata::Transition& t,
                  const automata::Formula& goal);

/// What a command does for which no goal asks: the first forbidden step that it may take and that does not come, now or
/// later, while all controls are idle, where they can be and something can follow.
const automata::Transition* forbidden_step(const Step& step, const automata::Modes& modes,
                                           const automata::ControlAction& action, const automata::Formula& goal);

/// Whether what a component can do in a mode is not the same in all states and under all commands: what must hold, at
/// least, of one that is commandable.
bool is_swayed(const Step& step, std::size_t component, automata::ModeId mode);

/// Whether of two goal states that are as good otherwise the left one goes first: greater summed reward; fewer
/// components changed.
bool is_better(const automata::Plant& plant, const automata::Modes& from, const automata::Modes& left,
               const automata::Modes& right);

/// The best of the states that are reached from one that entails the goal by single commands with one outcome each, all
/// of which can be undone, through states that entail it and in which nothing happens of itself.
automata::Modes best_kept(const Step& step, const automata::Modes& modes, const automata::Formula& goal);

/// The fewest such commands after which the goal is entailed first. Nothing where there are none.
std::optional<std::size_t> fewest_commands(const Step& step, const automata::Modes& modes,
                                           const automata::Formula& goal);
/// The same where no other component moves, on the way neither.
std::optional<std::size_t> fewest_commands_alone(const Step& step, const automata::Modes& modes,
                                                 automata::ComponentId component, const automata::Formula& goal);

double reward_of(const automata::Plant& plant, const automata::Modes& modes);

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

}  // namespace rmpl::reference
