// A log: what was commanded, observed or estimated, one JSON object a line.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "automata/json/parse.hpp"
#include "automata/phca.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/time/time.hpp"
#include "runtime/telemetry/log_times.hpp"
#include "runtime/telemetry/monitors.hpp"

namespace rmpl::runtime {

/// What one line says; what it does not say is empty. The other keys of a trace are legal and not kept.
struct LogLine {
  std::size_t number = 0;  ///< of the line in the file, from 1
  std::optional<std::uint64_t> cycle;
  automata::Ticks time;         ///< where the line has none: that of the line before, or 0
  bool timed = false;           ///< whether the line has one
  std::uint64_t unchanged = 0;  ///< cycles that were left out before this line; each was as the line before it says
  automata::Ticks before;       ///< the time of the line before
  std::optional<std::vector<automata::Assignment>> estimate;  ///< sorted by variable, like all of these
  std::vector<automata::Assignment> command;                  ///< control variables
  bool commanded = false;                                     ///< whether the line has a command, be it an empty one
  automata::Observation observations;
  automata::Observation set_aside;  ///< of these: what an estimator could not explain
  std::vector<Sample> samples;      ///< of the channels of monitors, in the order of the line
  std::vector<std::string> known;   ///< what is so of what a program asks of the executive's knowledge

  /// Whether it tells what is seen at the start, where no step was taken before it: at time 0, under no command, or as
  /// the cycle 0 of a trace.
  [[nodiscard]] bool is_of_start() const { return time == automata::Ticks{} && (!commanded || cycle == 0); }
  /// The time of a cycle that was left out, from 1 to `unchanged`: they lie evenly between `before` and `time`.
  [[nodiscard]] automata::Ticks time_of_unchanged(std::uint64_t cycle_left_out) const;
};

/// Where lines of a log come from.
class LogSource {
 public:
  virtual ~LogSource() = default;
  /// The next line, or nothing at the end. Throws base::InputError, located by file and line, where it is wrong.
  virtual std::optional<LogLine> next() = 0;
  /// What the times are like so far.
  [[nodiscard]] virtual LogTimes& times() = 0;
};

/// Reads a log line by line, whatever detail the trace that it came from has. A line that tells changes
/// (`"delta":true`) comes out whole; before the first line that is whole such lines are passed over. Errors are
/// base::InputError, located by file and line.
class LogReader final : public LogSource {
 public:
  enum class Role { estimate, command, observations };
  /// A line that tells nothing but what was seen is a *sample*. One with an odd time (`TimeFate`) is an error, or it is
  /// left out and counted. A line that commands, or that numbers a cycle, is a step: its odd time is an error always.
  enum class OddSamples { refused, left_out };

  /// Over a plant's names. `name` is the file's, for messages. Keeps a reference to `in` and `plant`.
  LogReader(std::istream& in, std::string name, const automata::Plant& plant);
  /// Over a model program's: commands of its controls, readings of any of its variables.
  LogReader(std::istream& in, std::string name, const automata::ModelProgram& program);
  /// Names are taken as they come: variables and values that `variables` lacks are added to it.
  LogReader(std::istream& in, std::string name, automata::Variables& variables);

  /// To be called before the first line is read: names of channels are known besides, as `observations`, below the key
  /// `channels`, or as keys of the line. Keys that nothing knows are passed over where they hold no more than a number,
  /// a text, true, false or null. Keeps a reference.
  void read_channels(const Monitors& monitors) { monitors_ = &monitors; }
  /// To be called before the first line is read; without, times count from 0 and odd samples are refused.
  void read_times(LogTimeOptions options, OddSamples odd);

  /// The next line that is not blank, or nothing at the end. Throws where a line is no JSON object, has a key twice or
  /// one that no trace has, a value of the wrong type, a name or value that the plant lacks (with the nearest one), an
  /// observed mode, a time that is none or an odd one that is refused, or more cycles left out than there are
  /// nanoseconds.
  std::optional<LogLine> next() override;
  [[nodiscard]] LogTimes& times() override { return times_; }

 private:
  /// Turns a name and a value into an assignment; what it throws is prefixed with file and line.
  using Resolve = std::function<automata::Assignment(Role role, const std::string& name, const std::string& value)>;
  /// Finds the variable of a name, if there is one.
  using Find = std::function<std::optional<automata::VariableId>(const std::string& name)>;

  [[nodiscard]] bool get_line(std::string& text);
  [[nodiscard]] std::optional<TimeText> time_ahead();
  [[nodiscard]] bool read_time(const std::string& text, const automata::Json& json, bool sample, LogLine& line);
  [[nodiscard]] bool interpret(const std::string& text, LogLine& line);
  void place(LogLine& line, bool first) const;
  /// Whether the line tells changes to the one before, which it then starts as.
  [[nodiscard]] bool is_delta(const automata::Json& json, LogLine& line) const;
  void assign(Role role, const std::string& key, const automata::Json& json, bool delta,
              std::vector<automata::Assignment>& into, LogLine* line = nullptr) const;
  bool add_sample(const std::string& name, const automata::Json& json, LogLine& line) const;
  [[nodiscard]] static std::vector<std::string> names(const std::string& key, const automata::Json& json);

  std::istream& in_;
  std::string name_;
  Resolve resolve_;
  Find find_;
  bool of_markings_ = false;  ///< modes that a line estimates are not read: a model program has none
  const Monitors* monitors_ = nullptr;
  std::size_t number_ = 0;
  std::optional<std::string> ahead_;  ///< the line after the last that was handed out, where its time had to be known
  LogTimes times_;
  OddSamples odd_ = OddSamples::refused;
  bool begun_ = false;
  std::optional<std::uint64_t> last_cycle_;
  automata::Ticks last_time_;
  LogLine last_;                                                       ///< what a line that tells changes rests on
  std::pair<automata::Observation, std::vector<Sample>> last_sample_;  ///< at `last_time_`, where the line was one
};

/// All lines of a log.
std::vector<LogLine> read_log(std::istream& in, const std::string& name, const automata::Plant& plant);
std::vector<LogLine> read_log(std::istream& in, const std::string& name, automata::Variables& variables);

}  // namespace rmpl::runtime
