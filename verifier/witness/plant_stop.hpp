// How the run of a plant is cut off where it ends, told by the rules alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "automata/step/plain_step.hpp"
#include "verifier/property/commands.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// Sets `stop`, and appends the steps that lead round where time stands still. Why the run can go on after all; nothing
/// where it cannot.
std::optional<std::string> explain_stop(automata::PlainStep& rules, Witness& witness, Commands commands,
                                        std::optional<automata::Ticks> period);

}  // namespace rmpl::verifier
