// Whether a goal that is achieved lasts.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/goal.hpp"
#include "runtime/reasoning/reconfigure/goal_interpreter.hpp"

namespace rmpl::runtime {

/// In a state that entails the goal, all controls idle, an untimed transition of a component that is `wanted` may take
/// the goal away again, as that of a load does that has lost its supply, or several may, one after the other. Which
/// components are to blame: those that move, and those that their guards read. Nothing where it lasts, as far as
/// untimed transitions can tell.
std::optional<std::vector<automata::ComponentId>> undone_by_itself(automata::Modes state,
                                                                   const std::vector<bool>& wanted, const Goal& goal,
                                                                   automata::PlantStep& step,
                                                                   GoalInterpreter& interpreter);

/// In a state, all controls idle, a component may leave its mode by itself, at once or in time. Which components are to
/// blame: that one, and those that its guard reads. None where it stays.
std::vector<automata::ComponentId> left_by_itself(const automata::Modes& state, automata::ComponentId component,
                                                  automata::PlantStep& step);

/// Of the moves from some modes to others, those without which another would not stay where it goes; nothing where
/// there are none.
std::optional<automata::Modes> rested_on(const automata::Modes& modes, const automata::Modes& end,
                                         automata::PlantStep& step);

}  // namespace rmpl::runtime
