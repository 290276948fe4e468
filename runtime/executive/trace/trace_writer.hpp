// Writes a run as JSON Lines; the file is complete or not there.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "automata/program.hpp"
#include "base/output_file.hpp"
#include "runtime/executive/trace/cycle_record.hpp"
#include "runtime/executive/trace/json_line.hpp"

namespace rmpl::runtime {

/// How much of a run a trace tells; each can be read as a log.
enum class TraceDetail {
  changes,  ///< the cycles in which something but the time and the belief changed, and the last
  cycles,   ///< every cycle, without the belief
  beliefs   ///< every cycle, with all states that are tracked
};

/// A trace file (grammar/schema/trace.schema.json). Its first line has `cycle` 0 and states where the run starts; the
/// line of cycle k then has the marking, goal and command with which the cycle started, and the observations and
/// estimate that it read back at `time`. So a trace is a log: `rmpl-run estimate` and `rmpl-run sequence` repeat it.
/// Where cycles were left out, the next line says how many.
/// Unless `keep` is called the file is as it was: a run that fails midway leaves no trace, or the one before.
class TraceWriter final : public CycleObserver {
 public:
  /// Throws base::InputError where the file cannot be written.
  TraceWriter(const automata::Plant& plant, const automata::Program& program, std::string path,
              TraceDetail detail = TraceDetail::changes);
  void observe(const CycleRecord& record) override;
  /// The run is over and the file stays. Throws base::InputError where it could not be written in full.
  void keep();

 private:
  /// What a line is about besides cycle, time, evidence and belief.
  struct Told {
    automata::Marking marking;
    std::vector<automata::Assignment> goal;
    std::vector<automata::LocationId> asserted_by;
    automata::ControlAction command;
    Reconfiguration::Outcome outcome;
    Reason why;
    automata::Observation observations;
    automata::Modes estimate;
    std::optional<automata::Modes> truth;
    std::vector<Event> events;

    explicit Told(const CycleRecord& record);
    [[nodiscard]] bool still_true_of(const CycleRecord& record) const;
  };

  void write(std::uint64_t cycle, automata::Ticks time, const Told& told, const std::vector<Evidence>& evidence,
             const Belief* belief);
  void write_goal(const Told& told);

  const automata::Plant& plant_;
  const automata::Program& program_;
  TraceDetail detail_;
  base::OutputFile file_;
  JsonLine line_;
  ClockTable live_clocks_;  ///< the executive forgets the others
  std::optional<Told> told_;
  std::uint64_t unchanged_ = 0;  ///< cycles since the last line
  std::uint64_t last_cycle_ = 0;
  automata::Ticks last_time_;
};

/// The array of a cycle's events, as in traces.
void write_events(JsonLine& line, const std::vector<Event>& events, const automata::Plant* plant);

}  // namespace rmpl::runtime
