// Where a belief most likely goes by one step, whatever is seen: the story that an observation refutes.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {

/// The possible modes of the likeliest single trajectory that leaves a state of `belief`, as of `before`, and ends at
/// `now`, and that hold nothing which is `avoided` (a variable is a component, a value a mode); ties to the state first
/// in the belief, then in declaration order. Nothing where there is none.
std::optional<automata::Modes> likeliest_successor(automata::PlantStep& step, const Belief& belief,
                                                   const automata::ControlAction& action, automata::Ticks before,
                                                   automata::Ticks now, const ConflictSet& avoided);

}  // namespace rmpl::runtime
