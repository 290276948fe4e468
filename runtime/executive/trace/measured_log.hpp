// A log whose samples become readings, line by line or cycle by cycle.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "runtime/executive/trace/log.hpp"
#include "runtime/telemetry/monitors.hpp"

namespace rmpl::runtime {

/// Each line has, besides its own observations, what the monitors say at its time; of an attribute that both speak of
/// the line's own counts. With a period there is a line for each cycle in place of those of the log: a line of the log
/// belongs to the first cycle that ends at or after its time, of the commands in a cycle the last that is not idle
/// counts, and what was sampled is listed once, with its last sample. The last cycle is the one of the last line.
class MeasuredLog final : public LogSource {
 public:
  /// Keeps references to `source` and `monitors`. The period is above 0.
  MeasuredLog(LogSource& source, Monitors& monitors, std::optional<automata::Ticks> period = std::nullopt)
      : source_(source), monitors_(monitors), period_(period) {}

  std::optional<LogLine> next() override;
  [[nodiscard]] LogTimes& times() override { return source_.times(); }

 private:
  std::optional<LogLine> cycle();
  void add_readings(LogLine& line) const;

  LogSource& source_;
  Monitors& monitors_;
  std::optional<automata::Ticks> period_;
  std::optional<LogLine> ahead_;  ///< of a later cycle
  automata::Ticks end_;           ///< of the cycle before
  bool begun_ = false;
  LogLine last_;  ///< the command and the direct observations in force
};

}  // namespace rmpl::runtime
