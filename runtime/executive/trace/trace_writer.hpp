// Writes a run as JSON Lines, one object a cycle; the file is complete or not there.
// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <string>

#include "automata/plant.hpp"
#include "runtime/executive/trace/cycle_record.hpp"
#include "runtime/executive/trace/json_line.hpp"

namespace rmpl::runtime {

/// A trace file (grammar/schema/trace.schema.json). Its first line has `cycle` 0 and states where the run starts; the
/// line of cycle k then has the marking, goal and command with which the cycle started, and the observations and
/// estimate that it read back at `time`. So a trace is a log: `rmpl-run estimate` and `rmpl-run sequence` repeat it.
/// Unless `keep` is called the file is removed: a run that fails midway leaves none.
class TraceWriter final : public CycleObserver {
 public:
  /// Throws base::InputError where the file cannot be written.
  TraceWriter(const automata::Plant& plant, std::string path);
  ~TraceWriter() override;
  TraceWriter(const TraceWriter&) = delete;
  TraceWriter& operator=(const TraceWriter&) = delete;

  void observe(const CycleRecord& record) override;
  /// The run is over and the file stays. Throws base::InputError where it could not be written in full.
  void keep();

 private:
  const automata::Plant& plant_;
  std::string path_;
  std::ofstream file_;
  JsonLine line_;
  ClockTable live_clocks_;  ///< the executive forgets the others
  bool kept_ = false;
};

/// The array of a cycle's events, as in traces.
void write_events(JsonLine& line, const std::vector<Event>& events, const automata::Plant* plant);

}  // namespace rmpl::runtime
