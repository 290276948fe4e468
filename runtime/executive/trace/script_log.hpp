// Scenarios of Livingstone2 (`.scr`) as logs: a step a line.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>

#include "automata/plant.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/executive/trace/log_names.hpp"
#include "runtime/telemetry/log_times.hpp"

namespace rmpl::runtime {

/// `progress a=v …` takes a step under these commands, all others idle; `assign b=w …` reads what is seen after it,
/// `unassign b …` takes that back. What asks Livingstone2 for an answer or shows its state (`fc`, `echo`, `cover`, …)
/// is passed over: the answer is what was estimated after the step. Step n ends at n periods; what is read before the
/// first step is read at the start. `//` and `;` begin comments.
class ScriptLog final : public LogSource {
 public:
  /// Keeps references to `in` and `plant`. The period is above 0.
  ScriptLog(std::istream& in, std::string name, const automata::Plant& plant, automata::Ticks period);

  /// Throws base::InputError, located by file and line, where a line is none of these, or names what the plant lacks.
  std::optional<LogLine> next() override;
  [[nodiscard]] LogTimes& times() override { return times_; }

 private:
  [[noreturn]] void fail(const std::string& what) const;
  bool read_line();

  std::istream& in_;
  std::string name_;
  const automata::Plant& plant_;
  LogNames names_;
  automata::Ticks period_;
  LogTimes times_;
  std::size_t number_ = 0;
  std::int64_t steps_ = 0;
  bool ended_ = false;
  LogLine line_;                  ///< of the step that goes on
  std::optional<LogLine> ready_;  ///< of the one before it
};

}  // namespace rmpl::runtime
