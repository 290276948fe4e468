// A log: what was commanded, observed or estimated, one JSON object a line.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "automata/json/parse.hpp"
#include "automata/phca.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/time/time.hpp"

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

  /// Whether it tells what is seen at the start, where no step was taken before it: at time 0, under no command, or as
  /// the cycle 0 of a trace.
  [[nodiscard]] bool is_of_start() const { return time == automata::Ticks{} && (!commanded || cycle == 0); }
  /// The time of a cycle that was left out, from 1 to `unchanged`: they lie evenly between `before` and `time`.
  [[nodiscard]] automata::Ticks time_of_unchanged(std::uint64_t cycle_left_out) const;
};

/// Reads a log line by line, whatever detail the trace that it came from has. Errors are base::InputError, located by
/// file and line.
class LogReader {
 public:
  enum class Role { estimate, command, observations };

  /// Over a plant's names. `name` is the file's, for messages. Keeps a reference to `in` and `plant`.
  LogReader(std::istream& in, std::string name, const automata::Plant& plant);
  /// Over a model program's: commands of its controls, readings of any of its variables.
  LogReader(std::istream& in, std::string name, const automata::ModelProgram& program);
  /// Names are taken as they come: variables and values that `variables` lacks are added to it.
  LogReader(std::istream& in, std::string name, automata::Variables& variables);

  /// The next line that is not blank, or nothing at the end. Throws where a line is no JSON object, has a key twice or
  /// one that no trace has, a value of the wrong type, a name or value that the plant lacks (with the nearest one), an
  /// observed mode, a time that lies before that of an earlier line or is no whole number of nanoseconds, or more
  /// cycles left out than there are nanoseconds.
  std::optional<LogLine> next();

 private:
  /// Turns a name and a value into an assignment; what it throws is prefixed with file and line.
  using Resolve = std::function<automata::Assignment(Role role, const std::string& name, const std::string& value)>;

  void interpret(const std::string& text, LogLine& line) const;
  void place(LogLine& line, bool first) const;
  [[nodiscard]] std::vector<automata::Assignment> assignments(Role role, const std::string& key,
                                                              const automata::Json& json) const;

  std::istream& in_;
  std::string name_;
  Resolve resolve_;
  std::size_t number_ = 0;
  bool begun_ = false;
  std::optional<std::uint64_t> last_cycle_;
  automata::Ticks last_time_;
};

/// All lines of a log.
std::vector<LogLine> read_log(std::istream& in, const std::string& name, const automata::Plant& plant);
std::vector<LogLine> read_log(std::istream& in, const std::string& name, automata::Variables& variables);

}  // namespace rmpl::runtime
