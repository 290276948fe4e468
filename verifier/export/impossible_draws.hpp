// Modes that contradict each other and may be drawn: what synchronised modules cannot say.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/export/influence.hpp"
#include "verifier/search/limits.hpp"

namespace rmpl::verifier {

/// The controls off idle; `all controls idle` without one.
std::string describe(const automata::Plant& plant, const automata::ControlAction& action);

/// Where modes that contradict the store may be drawn, the semantics draws again; modules cannot. Only components that
/// have to do with it are looked at, and time is not: some that no run comes to may be refused. `initial`: the modes to
/// start in, by component. Throws base::InputError where there are such modes, or where a command contradicts the modes
/// in which it is given; LimitReached, where a combination of modes counts as a state.
void refuse_impossible_draws(automata::PlantStep& step, Influence& influence,
                             const std::vector<std::vector<automata::ModeId>>& initial,
                             const std::vector<automata::ControlAction>& actions, Meter& meter);

}  // namespace rmpl::verifier
