// The next step of a strategy, as reconfiguration answers it, with its reason (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "automata/logic/formula.hpp"
#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/game/strategist.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// From possible modes, where groups in force go on. Nothing where the strategist does not solve the goal, and where
/// components that it leaves out are stuck. Where no run at all leads to the goal, the obstacle is not found: it stands
/// in the model, not in the game.
///
/// `expected` is what follows if each action has the outcome of least cost. If all groups wait, the transition comes
/// that the shortest wait is for, and no other timed one.
std::optional<Reconfiguration> strategy_answer(automata::PlantStep& step, const NominalGraph& graph,
                                               Strategist& strategist, const automata::Modes& modes,
                                               const StrategyPosition& position);

}  // namespace rmpl::runtime
