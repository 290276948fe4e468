// Goals that contradict each other, as an event (semantics 2).
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/program.hpp"
#include "automata/step/program_step.hpp"
#include "runtime/executive/trace/event.hpp"

namespace rmpl::runtime {

/// Names both locations, what they assert, and their source lines. `variables` are those of the goal's assignments.
Event describe(const automata::GoalConflict& conflict, const automata::Program& program,
               const automata::Variables& variables);

}  // namespace rmpl::runtime
