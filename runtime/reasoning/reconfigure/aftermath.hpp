// What follows by itself on a state (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/reason.hpp"

namespace rmpl::runtime {

/// A state, and the nominal transitions that led there from the one before; none of them stays where it is.
struct Consequence {
  automata::Modes modes;
  std::vector<TransitionOf> moves;
};

/// The states that untimed transitions of some components lead to with all controls idle, one step after the other,
/// each component taking the first that is enabled: to where they rest, or the model tolerates no more. Up to 16 steps.
std::vector<Consequence> aftermath(automata::Modes modes, std::span<const automata::ComponentId> components,
                                   automata::PlantStep& step);

}  // namespace rmpl::runtime
