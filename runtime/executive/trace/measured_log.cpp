// Samples are taken in the order of the log; readings are asked at the end of a cycle.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/measured_log.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;
using automata::Ticks;

constexpr std::int64_t most_silent = 10'000'000;  ///< cycles in a row; more is a log of another origin

/// The end of the first cycle that ends at or after a time.
Ticks cycle_of(Ticks time, Ticks period) {
  const std::int64_t rest = time.count % period.count;
  return rest == 0 ? time : Ticks{time.count - rest + period.count};
}

/// Of two readings of one attribute the later one is kept.
void merge(automata::Observation& into, const automata::Observation& later) {
  if (later.empty()) return;
  for (const Assignment& reading : later) {
    std::erase_if(into, [&](const Assignment& known) { return known.variable == reading.variable; });
    into.push_back(reading);
  }
  std::sort(into.begin(), into.end());
}

void merge(std::vector<Sample>& into, const std::vector<Sample>& later) {
  for (const Sample& sample : later) {
    std::erase_if(into, [&](const Sample& known) { return known.channel == sample.channel; });
    into.push_back(sample);
  }
}

}  // namespace

void MeasuredLog::add_readings(LogLine& line) const {
  automata::Observation readings = monitors_.readings(line.time);
  merge(readings, line.observations);
  line.observations = std::move(readings);
}

std::optional<LogLine> MeasuredLog::next() {
  if (period_) return cycle();
  auto line = source_.next();
  if (!line) return line;
  monitors_.take(line->samples, line->time);
  add_readings(*line);
  return line;
}

std::optional<LogLine> MeasuredLog::cycle() {
  if (!ahead_) ahead_ = source_.next();
  if (!ahead_) return std::nullopt;
  LogLine cycle;
  cycle.before = end_;
  cycle.timed = true;
  // What is seen at the start, at time 0, is a line of its own: no cycle ends there.
  const bool start = !begun_ && ahead_->is_of_start();
  if (!start && (ahead_->time - end_).count / period_->count > most_silent) {
    throw base::InputError("between " + automata::format_seconds(end_) + " s and the sample at " +
                           automata::format_seconds(ahead_->time) + " s lie more than " + std::to_string(most_silent) +
                           " cycles of " + automata::format_seconds(*period_) +
                           " s; expected --origin first, or another --cycle");
  }
  end_ = start ? Ticks{} : end_ + *period_;
  begun_ = true;
  cycle.number = last_.number;
  cycle.time = end_;
  cycle.command = last_.command;
  cycle.commanded = !start;
  bool acted = false;  // a control was off idle in this cycle
  while (ahead_ && cycle_of(ahead_->time, *period_) <= end_) {
    cycle.number = last_.number = ahead_->number;
    monitors_.take(ahead_->samples, ahead_->time);
    if (ahead_->commanded) {
      last_.command = ahead_->command;
      acted = acted || !ahead_->command.empty();
      if (!acted || !ahead_->command.empty()) cycle.command = ahead_->command;
    }
    merge(cycle.observations, ahead_->observations);
    merge(cycle.samples, ahead_->samples);
    ahead_ = source_.next();
  }
  add_readings(cycle);
  return cycle;
}

}  // namespace rmpl::runtime
