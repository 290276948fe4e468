// Origins and units, as they are typed.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/log_options.hpp"

#include <string>

#include "compiler/session/monitors.hpp"
#include "grammar/source/render.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/options.hpp"
#include "tools/shared/program.hpp"

namespace rmpl::tools {

void add_log_times(Command& command, LogOptions& options) {
  const auto take_origin = [&options](const std::string& text) {
    options.times.from_first = text == "first";
    options.times.origin = options.times.from_first ? std::nullopt : runtime::read_time_text(text);
    if (!options.times.from_first && !options.times.origin) {
      throw BadValue("expected first, seconds or a date, such as 2023-11-14T22:13:20Z, not '" + text + "'");
    }
  };
  command
      .add_taken("--origin", take_origin,
                 "which time of the log is time 0: the first one, a number of seconds, or a date")
      .option_text("first|TIME");
  const auto take_unit = [&options](const std::string& text) {
    const auto unit = text == "s" || text == "ms" || text == "us" || text == "ns" ? automata::parse_duration("1" + text)
                                                                                  : std::nullopt;
    if (unit) return void(options.times.unit = unit->count);
    throw BadValue("expected s|ms|us|ns, not '" + text + "'");
  };
  command
      .add_taken("--time-unit", take_unit,
                 "the unit of times that are bare numbers (default: s; Unix time by its size)")
      .option_text("s|ms|us|ns");
}

void add_telemetry(Command& command, LogOptions& options) {
  command
      .add_option("--monitors", options.monitors_file,
                  "monitors that turn numbers and texts of the log's channels into readings")
      .option_text("FILE.mon");
  command
      .add_option("--time-column", options.time_column,
                  "of a CSV log (default: the first called time, timestamp, datetime, date or t)")
      .option_text("NAME");
  const auto read_delimiter = [](const std::string& text) {
    if (text == "tab" || text == "\\t") return '\t';
    if (text.size() != 1 || text == "\"" || text == "\n" || text == "\r") {
      throw BadValue("expected one character or tab, not '" + text + "'");
    }
    return text.front();
  };
  add_read(command, "--delimiter", options.delimiter, read_delimiter,
           "of a CSV log: a character, or tab (default: what its first row has most of , ; and tab)")
      .option_text("C");
  add_read(command, "--cycle", options.period, positive_duration,
           "answer once per cycle of this length, instead of once per line of the log")
      .option_text("TIME");
}

std::vector<automata::Monitor> load_monitors(const std::string& path, const automata::Plant& plant,
                                             const Common& common) {
  grammar::Findings findings;
  auto monitors = compiler::compile_monitors(path, plant, findings);
  if (!monitors) {
    tell_findings(findings, common);
    throw Rejected{grammar::render_text(findings, false)};
  }
  return std::move(*monitors);
}

}  // namespace rmpl::tools
