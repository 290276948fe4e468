// How a search sees what is wanted: tests of modes, and whether there is a way to a state that passes.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/plant/observer.hpp"
#include "verifier/plant/plant_system.hpp"
#include "verifier/search/search.hpp"

namespace rmpl::verifier {

/// The components whose modes decide a formula.
automata::Support support_of(const automata::PlantStep& step, const automata::Formula& formula);

/// Whether the formula holds at a state: the store implies it, or (not `certain`) allows it. Asked once for the modes
/// that it can depend on. Keeps a reference to the step function.
Observer::Test holds(automata::PlantStep& step, const automata::Formula& formula, bool certain);

/// Some path to an accepted state, where there is one. With `merge` merged states tell whether there is; one is then
/// looked for where they found it: a merged state may allow a joint step that its parts, whose clocks are known better,
/// take one by one. Throws LimitReached.
std::optional<std::vector<PathState>> any_path(PlantSystem& system, bool merge, Meter& meter);

}  // namespace rmpl::verifier
