// The modes, readings and places at the time when an expectation failed, in a few words.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/program.hpp"
#include "runtime/executive/trace/cycle_record.hpp"

namespace rmpl::runtime {

/// What a cycle has of the variables that a formula mentions: their modes, as estimated or true, and what was read of
/// them and of these components; no more than four. `engine = heating, engine.temp = low`.
std::string circumstances(const automata::Formula& formula, const CycleRecord& record, const automata::Plant& plant,
                          bool truth);

/// Where a program is: its marked primitive locations, no more than two. `when t >= 10 s (entry.rmpl:12)`.
std::string places(const automata::Marking& marking, const automata::Program& program);

/// What the executive did in a cycle, and why: `cycle 7: engine.cmd = standby for engine = standby, …`; or that it
/// waited, or was without a plan; or its number alone. Empty for cycle 0.
std::string deed(const CycleRecord& record, const automata::Plant& plant);

}  // namespace rmpl::runtime
