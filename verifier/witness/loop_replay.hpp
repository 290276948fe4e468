// Replaying a run of the closed loop on the step functions of semantics 2 and 3, apart from all that found it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// Under which rules a run is to be possible.
struct LoopRules {
  std::optional<automata::Ticks> period;  ///< sampled time; none: dense
  unsigned faults = 0;
  std::vector<automata::Assignment> from;  ///< modes to start in, in place of the initial distribution
  bool endless = false;                    ///< the wait at the end is to last for ever
};

/// Why the run is not possible; nothing where it is. Every cycle is run: sequencer, reconfigurer, plant. Of the
/// cycles of a wait those are run in which a clock is near a constant of the program or a bound of its mode: between
/// them nothing differs.
std::optional<std::string> replay(const automata::Program& program, automata::PlantStep& step,
                                  runtime::Reconfigurer& reconfigurer, const Witness& witness, const LoopRules& rules);

}  // namespace rmpl::verifier
