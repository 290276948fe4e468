// The control sequencer alone, fed from a log of state estimates (thesis 5.3, 5.4).
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "automata/plant.hpp"
#include "automata/program.hpp"
#include "runtime/executive/trace/log.hpp"

namespace rmpl::runtime {

/// Takes one answer, a line without its end.
using Answer = std::function<void(std::string_view line)>;

/// Line i of a log holds time, estimate and observations at the start of cycle i, and those of line i + 1 are what its
/// cycle reads back: n + 1 lines are n cycles. Cycles that a line says were left out are run like the others, and
/// answered. An estimate that a line lacks is that of the line before. Both answer one JSON object a cycle, as soon as
/// the line that it reads back was read: `cycle`, `time`, `marking` at the start of the cycle, `goal`, `clocks` in
/// seconds of the active ones, and `events` where goals contradict each other. A cycle that starts with the empty
/// marking is the last; the lines after it are read, and not answered. They throw base::InputError where the log is
/// wrong. No more than two lines are kept at a time.

/// With a plant: entailment by its model; `program` is bound to it. Observations that contradict the estimate are an
/// event `inconsistent` and are not looked at, as in the executive.
void sequence_log(const automata::Program& program, const automata::Plant& plant, std::istream& log,
                  const std::string& name, const Answer& answer);

/// Without a plant: names as they come. Entailment is that of an open world: a variable may have a value that neither
/// the program nor the log mentions.
void sequence_log(const automata::Program& program, std::istream& log, const std::string& name, const Answer& answer);

/// Both again, all answers together, each with its end of line.
std::string sequence_log(const automata::Program& program, const automata::Plant& plant, std::istream& log,
                         const std::string& name);
std::string sequence_log(const automata::Program& program, std::istream& log, const std::string& name);

}  // namespace rmpl::runtime
