// Replaying a run of the closed loop on the step functions of semantics 2 and 3, apart from all that found it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verifier/witness/replay.hpp"

namespace rmpl::verifier {

/// Why the run is not possible; nothing where it is. Every cycle is run: sequencer, reconfigurer, plant. Of the
/// cycles of a wait those are run in which a clock is near a constant of the program or a bound of its mode: between
/// them nothing differs.
std::optional<std::string> replay(const automata::Program& program, automata::PlantStep& step,
                                  runtime::Reconfigurer& reconfigurer, const Witness& witness,
                                  const ReplayRules& rules);

}  // namespace rmpl::verifier
