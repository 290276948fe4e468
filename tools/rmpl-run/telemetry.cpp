// Which reader a log gets, and what is told of it.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/telemetry.hpp"

#include "runtime/executive/trace/csv_log.hpp"
#include "runtime/executive/trace/script_log.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

/// Whether the first byte that is no blank opens a JSON text.
bool begins_with_bracket(std::istream& stream) {
  while (stream.good() &&
         (stream.peek() == ' ' || stream.peek() == '\n' || stream.peek() == '\r' || stream.peek() == '\t')) {
    stream.get();
  }
  return stream.peek() == '{' || stream.peek() == '[';
}

bool is_table(std::istream& stream, const std::string& path, const LogOptions& options) {
  if (path.ends_with(".csv") || path.ends_with(".tsv")) return true;
  if (!options.time_column.empty() || options.delimiter) return true;
  return !options.monitors_file.empty() && !path.ends_with(".jsonl") && !begins_with_bracket(stream);
}

}  // namespace

Telemetry::Telemetry(base::InputFile& input, const std::string& path, const automata::Plant& plant,
                     const LogOptions& options)
    : name_(input.name()), monitors_(options.monitors) {
  std::istream& stream = input.stream();
  if (options.script) {
    lines_ = std::make_unique<runtime::ScriptLog>(stream, name_, plant,
                                                  options.period.value_or(automata::Ticks::of_seconds(1)));
    return;
  }
  if (is_table(stream, path, options)) {
    const runtime::CsvLogOptions csv{options.delimiter, options.time_column, options.times, options.samples};
    lines_ = std::make_unique<runtime::CsvLog>(stream, name_, plant, monitors_, csv);
  } else {
    auto reader = std::make_unique<runtime::LogReader>(stream, name_, plant);
    reader->read_times(options.times, runtime::LogReader::OddSamples::left_out);
    if (!options.monitors_file.empty()) reader->read_channels(monitors_);
    lines_ = std::move(reader);
  }
  if (!options.monitors.empty() || options.period) measured_.emplace(*lines_, monitors_, options.period);
}

runtime::LogSource& Telemetry::source() {
  if (measured_) return *measured_;
  return *lines_;
}

void Telemetry::tell_remarks() {
  for (const std::string& remark : lines_->times().take_remarks()) tell("warning: " + name_ + ": " + remark);
  for (const std::string& remark : monitors_.take_remarks()) tell("warning: " + name_ + ": " + remark);
}

void Telemetry::tell_left_out() {
  for (const std::string& line : lines_->times().left_out()) tell("warning: " + name_ + ": " + line);
  for (const std::string& channel : monitors_.silent()) {
    tell("warning: " + name_ + ": no sample of channel \"" + channel + "\"");
  }
}

}  // namespace rmpl::tools
