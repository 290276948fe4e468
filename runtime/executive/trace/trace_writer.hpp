// Writes a run as JSON Lines; the file is complete or not there.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "automata/plant.hpp"
#include "automata/program.hpp"
#include "base/output_file.hpp"
#include "runtime/executive/trace/cycle_record.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/telemetry/sample.hpp"

namespace rmpl::runtime {

/// How much of a run a trace tells; each can be read as a log.
enum class TraceDetail {
  changes,  ///< the cycles in which something but the time and the belief changed, and the last; of each
            ///< what changed since the line before, with a keyframe, which tells all, every so often
  cycles,   ///< every cycle, without the belief
  beliefs   ///< every cycle, with all states that are tracked
};

/// A trace file (grammar/schema/trace.schema.json). Its first line has `cycle` 0 and states where the run starts; the
/// line of cycle k then has the marking, goal and command with which the cycle started, and the observations and
/// estimate that it read back at `time`. So a trace is a log: `rmpl-run estimate` and `rmpl-run sequence` repeat it.
/// Where cycles were left out, the next line says how many.
/// Samples of channels are no change: a line has the last of each channel since the line before.
/// A line that tells changes has `"delta":true`: what it does not have is as in the line before, and null is what is
/// there no longer. How many cycles it leaves out follows from the numbers of the cycles.
/// Unless `keep` is called the file is as it was: a run that fails midway leaves no trace, or the one before.
class TraceWriter final : public CycleObserver {
 public:
  /// Lines from one keyframe to the next.
  static constexpr std::uint64_t usual_keyframe = 1000;

  /// Throws base::InputError where the file cannot be written. `keyframe` is at least 1: all lines are keyframes.
  TraceWriter(const automata::Plant& plant, const automata::Program& program, std::string path,
              TraceDetail detail = TraceDetail::changes, std::uint64_t keyframe = usual_keyframe);
  /// Lines go elsewhere, one by one, each with its end.
  using Sink = std::function<void(std::string_view line)>;
  TraceWriter(const automata::Plant& plant, const automata::Program& program, Sink sink, TraceDetail detail,
              std::uint64_t keyframe = usual_keyframe);
  void observe(const CycleRecord& record) override;
  /// The run is over and the file stays. Throws base::InputError where it could not be written in full.
  void keep();

 private:
  /// What a line is about besides cycle, time, evidence and belief.
  struct Told {
    automata::Marking marking;
    automata::Goals goals;
    std::vector<LeftOut> left_out;
    std::vector<std::string> known;
    automata::ControlAction command;
    Reconfiguration::Outcome outcome;
    Reason why;
    automata::Observation observations, set_aside;
    automata::Modes estimate;
    std::optional<automata::Modes> truth;
    std::vector<Event> events;

    explicit Told(const CycleRecord& record);
    [[nodiscard]] bool still_true_of(const CycleRecord& record) const;
  };

  void hear(const CycleRecord& record);
  void write(std::uint64_t cycle, automata::Ticks time, const Told& told, const std::vector<Evidence>& evidence,
             const Belief* belief);
  void write_all(const Told& told, automata::Ticks time, const std::vector<Evidence>& evidence, const Belief* belief);
  void write_changes(const Told& told, const Told& before, const std::vector<Evidence>& evidence);
  void write_samples();
  void write_goal(const Told& told);
  void write_goal_changes(const Told& told, const Told& before);
  void write_constraints(const Told& told);
  void write_left_out(const Told& told);
  void write_known(const Told& told);
  void write_asserting(automata::LocationId location);
  void write_by(automata::Assignment goal, automata::LocationId location);

  const automata::Plant& plant_;
  const automata::Program& program_;
  TraceDetail detail_;
  std::optional<base::OutputFile> file_;  ///< nothing where lines go to the sink
  Sink sink_;
  JsonLine line_;
  ClockTable live_clocks_;  ///< the executive forgets the others
  const std::uint64_t keyframe_;
  std::vector<Sample> heard_;          ///< the last of each channel since the line before
  std::vector<std::string> channels_;  ///< their names
  std::optional<Told> told_;
  std::optional<Told> written_;       ///< by the last line
  std::uint64_t since_keyframe_ = 0;  ///< lines
  std::uint64_t unchanged_ = 0;       ///< cycles since the last line
  std::uint64_t last_cycle_ = 0;
  automata::Ticks last_time_;
};

/// The object of a cycle's samples, by the names of their channels; what is no finite number as its text.
void write_channels(JsonLine& line, const std::vector<Sample>& samples, const std::vector<std::string>& channels);

/// The array of a cycle's events, as in traces.
void write_events(JsonLine& line, const std::vector<Event>& events, const automata::Plant* plant);

}  // namespace rmpl::runtime
