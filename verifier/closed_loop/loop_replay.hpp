// Replaying a trace of the closed loop on the step functions of semantics 2 and 3, apart from all that found it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verifier/closed_loop/loop_trace.hpp"

namespace rmpl::verifier {

/// Under which rules a trace is to be possible.
struct LoopRules {
  std::optional<automata::Ticks> period;  ///< sampled time; none: dense
  unsigned faults = 0;
  std::vector<automata::Assignment> from;  ///< modes to start in, in place of the initial distribution
  bool endless = false;                    ///< the wait at the end is to last for ever
};

/// Why the trace is not possible; nothing where it is. Every cycle is run: sequencer, reconfigurer, plant. Of the
/// cycles of a wait those are run in which a clock is near a constant of the program or a bound of its mode: between
/// them nothing differs.
std::optional<std::string> replay(const automata::Program& program, automata::PlantStep& step,
                                  runtime::Reconfigurer& reconfigurer, const LoopTrace& trace, const LoopRules& rules);

}  // namespace rmpl::verifier
