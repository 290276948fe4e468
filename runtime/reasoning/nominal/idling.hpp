// What is sent where nothing is to be done (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/nominal/precondition.hpp"

namespace rmpl::runtime {

/// The tolerated action with the fewest controls off idle: all idle, where the store of the modes tolerates that. Of
/// several the one under which the fewest components have to leave their modes at once, then the first by the lists of
/// controls off idle with their values. So what has nothing to do with each other does not decide what the other is
/// sent. Idle where none is tolerated among the first 4,096.
automata::ControlAction resting_action(automata::PlantStep& step, const automata::Modes& modes);

/// The same of the actions that meet the precondition, under which a component is to move. Nothing where none is
/// tolerated among the first 4,096.
std::optional<automata::ControlAction> least_action(automata::PlantStep& step, const automata::Modes& modes,
                                                    const Precondition& precondition, automata::ComponentId moved);

}  // namespace rmpl::runtime
