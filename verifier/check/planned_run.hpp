// The run that reconfiguration would bring about: a plan as a witness of what can be reached.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "automata/step/plant_step.hpp"
#include "verifier/property/property.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// What is commanded from these modes on until the store implies the formula, and what follows of itself, each step as
/// early as the bounds of time let it; time goes on until the window begins. No fault happens. Nothing where there is
/// no plan. The run may still be none that is asked about (several commands at once, an outcome that is too unlikely, a
/// target that is met too late): that is for a replay to say. Costs what planning costs.
std::optional<Witness> planned_run(const automata::Plant& plant, const automata::Modes& start,
                                   const automata::Formula& target, const Window& window,
                                   std::optional<automata::Ticks> period);

}  // namespace rmpl::verifier
