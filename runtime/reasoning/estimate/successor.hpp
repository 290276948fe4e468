// Where a belief most likely goes by one step, whatever is seen: the story that an observation refutes.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

/// A mode that a component is not to be in.
struct Avoided {
  automata::ComponentId component;
  automata::ModeId mode;
};

/// The possible modes of the likeliest single trajectory that leaves a state of `belief`, as of `before`, and ends at
/// `now`; ties to the state first in the belief, then in declaration order. Nothing where no trajectory avoids the
/// mode.
std::optional<automata::Modes> likeliest_successor(automata::PlantStep& step, const Belief& belief,
                                                   const automata::ControlAction& action, automata::Ticks before,
                                                   automata::Ticks now, const std::optional<Avoided>& avoided);

}  // namespace rmpl::runtime
