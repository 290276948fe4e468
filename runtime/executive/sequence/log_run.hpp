// The control sequencer alone, fed from a log of state estimates (thesis 5.3, 5.4).
// SPDX-License-Identifier: MIT
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "automata/program.hpp"
#include "runtime/executive/trace/log.hpp"

namespace rmpl::runtime {

/// Line i of a log holds time, estimate and observations at the start of cycle i, and those of line i + 1 are what its
/// cycle reads back: n + 1 lines are n cycles. Cycles that a line says were left out are run like the others, and
/// answered. An estimate that a line lacks is that of the line before. Both answer
/// one JSON object a cycle: `cycle`, `time`, `marking` at the start of the cycle, `goal`, `clocks` in seconds of the
/// active ones, and `events` where goals contradict each other. A cycle that starts with the empty marking is the last.
/// They throw base::InputError where the log is wrong; nothing is answered then.

/// With a plant: entailment by its model; `program` is bound to it. Observations that contradict the estimate are an
/// event `inconsistent` and are not looked at, as in the executive.
std::string sequence_log(const automata::Program& program, const automata::Plant& plant, std::istream& log,
                         const std::string& name);

/// Without a plant: names as they come. Entailment is that of an open world: a variable may have a value that neither
/// the program nor the log mentions.
std::string sequence_log(const automata::Program& program, std::istream& log, const std::string& name);

}  // namespace rmpl::runtime
