// Reasons: the little that decides what a component may do.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/behaviour/decisions.hpp"

namespace rmpl::verifier {

/// What is enough to imply, or to refute, each guard of the component in its mode: the failed assumptions of the
/// proofs, controls first, without its own mode. Nothing where a guard is left open. No mode of the `unknown`
/// components (ascending) is assumed: the answer then holds in all of their modes.
std::optional<std::vector<Premise>> reason(automata::PlantStep& step, automata::ComponentId component,
                                           const automata::Modes& modes, const automata::ControlAction& action,
                                           const std::vector<automata::ComponentId>& unknown = {});

}  // namespace rmpl::verifier
