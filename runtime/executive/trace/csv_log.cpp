// Rows of a table as lines of a log.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/csv_log.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string_view>
#include <utility>

#include "automata/controls.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"

namespace rmpl::runtime {
namespace {

std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

std::string in_lower_case(std::string_view text) {
  std::string result;
  for (const char c : text) result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// The unit that a name ends with, `time_ms`, `time (ms)` or `time [ms]`, which is taken off.
std::optional<std::int64_t> take_unit(std::string& name) {
  for (const std::string_view unit : {"ns", "us", "ms", "s"}) {
    for (const auto& [open, close] : {std::pair("_", ""), {"(", ")"}, {"[", "]"}}) {
      const std::string ending = open + std::string(unit) + close;
      if (!name.ends_with(ending) || name.size() == ending.size()) continue;
      name = trimmed(name.substr(0, name.size() - ending.size()));
      return automata::parse_duration("1" + std::string(unit))->count;
    }
  }
  return std::nullopt;
}

}  // namespace

CsvLog::CsvLog(std::istream& in, std::string name, const automata::Plant& plant, const Monitors& monitors,
               const CsvLogOptions& options)
    : reader_(in, name, options.delimiter), name_(std::move(name)), plant_(plant), names_(plant), monitors_(monitors) {
  samples_ = options.samples;
  read_header(options);
}

void CsvLog::fail(const CsvRow& row, const std::string& what) const {
  throw base::InputError(name_ + ":" + std::to_string(row.line()) + ": " + what);
}

void CsvLog::read_header(const CsvLogOptions& options) {
  const CsvRow* row = reader_.next();
  if (row == nullptr) throw base::InputError(name_ + ": expected a first row with the names of the columns");
  std::map<std::string, std::size_t> known;
  for (std::size_t c = 0; c < row->size(); ++c) {
    Column column;
    column.name = trimmed((*row)[c]);
    const auto variable = plant_.variables.find(column.name);
    const auto& seen = plant_.observables;
    if (const auto channel = monitors_.find(column.name)) {
      column.kind = Column::Kind::channel;
      column.channel = *channel;
    } else if (variable && automata::is_control(plant_, *variable)) {
      column.kind = Column::Kind::command;
      commanded_ = true;
    } else if (variable && std::find(seen.begin(), seen.end(), *variable) != seen.end()) {
      column.kind = Column::Kind::observation;
    }
    const bool twice = !known.emplace(column.name, c).second;
    if (twice && column.kind != Column::Kind::none) fail(*row, "two columns are called '" + column.name + "'");
    columns_.push_back(std::move(column));
  }
  find_time(options);
  const bool none = std::all_of(columns_.begin(), columns_.end(), [](const Column& column) {
    return column.kind == Column::Kind::none || column.kind == Column::Kind::time;
  });
  if (none) {
    std::vector<std::string> names;
    for (const Column& column : columns_) names.push_back(column.name);
    const std::string& wanted = monitors_.channels().empty() ? std::string() : monitors_.channels().front();
    fail(*row, "no column is a channel of the monitors" +
                   (wanted.empty() ? "" : ", such as '" + wanted + "'" + base::suggestion(wanted, names)) +
                   ", a control variable or an observed attribute; expected the delimiter between the names, or "
                   "--delimiter");
  }
}

void CsvLog::find_time(const CsvLogOptions& options) {
  LogTimeOptions times = options.times;
  std::optional<std::size_t> found;
  std::vector<std::string> names;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    names.push_back(columns_[c].name);
    if (!found && !options.time_column.empty() && columns_[c].name == options.time_column) found = c;
  }
  if (options.time_column.empty()) {
    for (const std::string_view usual : {"time", "timestamp", "datetime", "date", "t"}) {
      for (std::size_t c = 0; c < columns_.size() && !found; ++c) {
        std::string name = in_lower_case(columns_[c].name);
        take_unit(name);
        if (name == usual && columns_[c].kind == Column::Kind::none) found = c;
      }
    }
  }
  if (!found) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    throw base::InputError(
        name_ + ": " +
        (options.time_column.empty()
             ? "no column is called time, timestamp, datetime, date or t; expected --time-column, one of " + all
             : "no column is called '" + options.time_column + "'" + base::suggestion(options.time_column, names)));
  }
  time_ = *found;
  columns_[time_].kind = Column::Kind::time;
  std::string name = in_lower_case(columns_[time_].name);
  if (const auto unit = take_unit(name); unit && !times.unit) times.unit = unit;
  times_ = LogTimes(std::move(times));
}

std::optional<TimeText> CsvLog::time_ahead() {
  const CsvRow* row = reader_.peek();
  return row == nullptr || row->size() <= time_ ? std::nullopt : read_time_text((*row)[time_]);
}

std::optional<LogLine> CsvLog::next() {
  while (const CsvRow* row = reader_.next()) {
    if (row->size() != columns_.size()) {
      fail(*row, "expected " + std::to_string(columns_.size()) + " cells, as in the first row, found " +
                     std::to_string(row->size()));
    }
    const auto time = read_time_text((*row)[time_]);
    if (!time) {
      fail(*row, "'" + columns_[time_].name +
                     "': expected seconds, a duration with a unit, a date or a mission time, "
                     "not '" +
                     std::string((*row)[time_]) + "'");
    }
    // Peeking leaves the row as it is.
    const auto place = times_.place(*time, [this] { return time_ahead(); });
    if (!place) fail(*row, "the time " + std::string((*row)[time_]) + " lies more than 292 years from the start");
    const bool repeated =
        place->fate == TimeFate::follows && last_time_ == place->time && !commanded_ && row->same_cells(last_);
    if (place->fate != TimeFate::follows || repeated) {
      if (commanded_) fail(*row, "an odd time, and the row commands: without it the rest would mean something else");
      times_.leave_out(repeated ? TimeFate::repeated : place->fate, row->line());
      continue;
    }
    LogLine line;
    line.number = row->line();
    line.before = last_time_.value_or(automata::Ticks{});
    line.time = place->time;
    line.timed = true;
    interpret(*row, line);
    last_ = *row;
    last_time_ = line.time;
    return line;
  }
  return std::nullopt;
}

void CsvLog::interpret(const CsvRow& row, LogLine& line) const {
  if (samples_) line.samples.reserve(columns_.size());
  line.commanded = commanded_;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const Column& column = columns_[c];
    const std::string_view cell = row[c];
    if (cell.empty() || column.kind == Column::Kind::none || column.kind == Column::Kind::time) continue;
    if (column.kind == Column::Kind::channel) {
      if (!samples_) continue;
      Sample sample = Sample::of_text(column.channel, cell);
      if (!sample.text.empty()) line.samples.push_back(std::move(sample));
      continue;
    }
    const bool command = column.kind == Column::Kind::command;
    const auto role = command ? LogReader::Role::command : LogReader::Role::observations;
    try {
      (command ? line.command : line.observations).push_back(names_.resolve(role, column.name, trimmed(cell)));
    } catch (const base::InputError& error) {
      fail(row, std::string(error.what()).substr(1));  // it begins with a blank
    }
  }
  std::sort(line.command.begin(), line.command.end());
  std::sort(line.observations.begin(), line.observations.end());
}

}  // namespace rmpl::runtime
