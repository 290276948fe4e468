// Timed traces of the closed loop: cycle by cycle, what is asserted, commanded and done.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verifier/closed_loop/program_system.hpp"
#include "verifier/search/search.hpp"

namespace rmpl::verifier {

/// One cycle. In dense time it takes no time.
struct LoopCycle {
  automata::Ticks begin, end;
  automata::Marking marking;                             ///< at its start
  std::vector<std::optional<automata::Ticks>> readings;  ///< of the program clocks, as this cycle sees them; nothing
                                                         ///< where a clock is not active or not read any more
  std::vector<automata::Assignment> goal;                ///< that is acted on
  std::vector<automata::GoalConflict> conflicts;
  runtime::Reconfiguration::Outcome outcome = runtime::Reconfiguration::Outcome::nothing_to_do;
  std::string reason;  ///< of a missing plan
  automata::ControlAction action;
  automata::Modes modes;  ///< at its end, as those below
  automata::Marking next;
};

/// From the start at time 0 to what was looked for. Between two cycles others run that change nothing: they assert and
/// command what the next one listed does.
struct LoopTrace {
  automata::Modes start;
  std::vector<LoopCycle> cycles;
  /// The cycle that runs at the end: its command is known, what it leads to is not. Waits up to its begin are like
  /// those between cycles.
  LoopCycle last;
  std::optional<std::size_t> repeats_from;  ///< the cycles from this position on go round for ever
};

/// The trace with the earliest times of a path of `ProgramSystem` to what the quest looks for.
LoopTrace earliest_loop_trace(const std::vector<PathState>& path, Loop& loop, const Quest& quest);

/// How many components went into a fault mode.
std::size_t faults_in(const automata::Plant& plant, const LoopTrace& trace);

}  // namespace rmpl::verifier
