// The executive on a live plant, from start to end.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "automata/program.hpp"
#include "runtime/executive/live/live_plant.hpp"
#include "runtime/executive/scenario/engines.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/executive/trace/cycle_record.hpp"

namespace rmpl::runtime {

struct LiveRun {
  automata::Ticks cycle = {automata::Ticks::per_second / 2};  ///< above 0
  automata::Ticks duration = automata::Ticks::infinite();     ///< the run ends with the cycle that reaches it
  automata::Ticks give_up = automata::Ticks::of_seconds(60);  ///< without a plant for so long, the run ends
  LiveOptions plant;
  ScenarioOptions engines;  ///< what they are made with
};

struct LiveResult {
  enum class End { program, duration, interrupted, abandoned };
  End end = End::program;
  std::uint64_t cycles = 0;
  std::uint64_t acknowledged = 0;  ///< of the commands, one a cycle
  automata::Ticks time;            ///< at the end of the last cycle
};

/// Runs until the program has ended, the duration is over, no plant was there for too long, or an interruption. The
/// cycle in which an interruption comes is cut short, and is observed like the others. Observers see every cycle, from
/// cycle 0 on, in order.
LiveResult run_live(const automata::Program& program, Engines& engines, Channel& channel, const LiveRun& options,
                    const std::vector<CycleObserver*>& observers);

/// How it ended, and what became of the commands; ends with a line feed.
std::string summary(const LiveResult& result, automata::Ticks give_up);
/// The same for programs (grammar/schema/live_result.schema.json).
std::string to_json(const LiveResult& result);

}  // namespace rmpl::runtime
