// What is sent where nothing is to be done (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/nominal/precondition.hpp"

namespace rmpl::runtime {

/// All controls idle; where the store of the modes does not tolerate that, the tolerated action with the fewest
/// controls off idle, before all others one under which no untimed transition changes a mode. Idle where it tolerates
/// none.
automata::ControlAction resting_action(automata::PlantStep& step, const automata::Modes& modes);

/// The same of the actions that meet the precondition, under which a component is to move. Nothing where none is
/// tolerated among the first 4,096.
std::optional<automata::ControlAction> least_action(automata::PlantStep& step, const automata::Modes& modes,
                                                    const Precondition& precondition, automata::ComponentId moved);

}  // namespace rmpl::runtime
