// Reads JSON Lines, strictly.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/log.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "runtime/executive/trace/log_names.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;
using automata::Json;
using automata::Ticks;

/// What a value is, for messages: of a number, the number itself.
std::string name_of(const Json& json) {
  if (json.is_number()) return json.dump();
  return json.is_null() ? "null" : json.type_name();
}

/// Parses one line.
Json parse_object(const std::string& text) {
  if (text.find('\0') != std::string::npos) throw base::InputError(" expected text, found a NUL byte");
  try {
    Json json = automata::parse_json(text);
    if (!json.is_object()) throw base::InputError(" expected a JSON object, not " + name_of(json));
    return json;
  } catch (const automata::JsonError& error) {
    throw base::InputError(" " + std::string(error.what()));
  } catch (const Json::parse_error& error) {
    throw base::InputError(std::to_string(error.byte) + ": not JSON; expected one object a line");
  } catch (const Json::exception&) {
    throw base::InputError(" a number is out of range");
  }
}

void expect(bool right, const std::string& key, const std::string& expected, const Json& json) {
  if (!right) throw base::InputError(" '" + key + "': expected " + expected + ", not " + name_of(json));
}

std::uint64_t count_of(const std::string& key, const Json& json) {
  expect(json.is_number_unsigned(), key, "a whole number", json);
  return json.get<std::uint64_t>();
}

/// The decimal as it is written: a double would lose nanoseconds from some hundred days on.
std::string written(const std::string& text, const std::string& key) {
  const auto place = automata::place_of(text, "/" + key, automata::JsonError::Blame::value);
  return text.substr(place.begin, place.end - place.begin);
}

Ticks time_of(const std::string& text, const Json& json) {
  const bool readable = json.is_number() || json.is_string();
  const std::string duration = json.is_string()   ? json.get<std::string>()
                               : json.is_number() ? written(text, "time")
                                                  : std::string();
  const auto time = readable ? automata::parse_duration(duration) : std::nullopt;
  if (!time || time->is_infinite()) {
    throw base::InputError(" 'time': expected seconds from 0 to 9.2e9 in whole nanoseconds, or a duration with a unit" +
                           (json.is_number() ? ", not " + duration
                            : readable       ? std::string()
                                             : ", not " + name_of(json)));
  }
  return *time;
}

}  // namespace

Ticks LogLine::time_of_unchanged(std::uint64_t cycle_left_out) const {
  __extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): __extension__ wants a typedef
  const Wide share = static_cast<Wide>(time.count - before.count) * static_cast<Wide>(cycle_left_out);
  return {before.count + static_cast<std::int64_t>(share / (static_cast<Wide>(unchanged) + 1))};
}

LogReader::LogReader(std::istream& in, std::string name, const automata::Plant& plant)
    : in_(in), name_(std::move(name)), resolve_([&plant](Role role, const std::string& variable, const auto& value) {
        return resolve(plant, role, variable, value);
      }) {}

LogReader::LogReader(std::istream& in, std::string name, const automata::ModelProgram& program)
    : in_(in), name_(std::move(name)), resolve_([&program](Role role, const std::string& variable, const auto& value) {
        return resolve(program, role, variable, value);
      }) {}

LogReader::LogReader(std::istream& in, std::string name, automata::Variables& variables)
    : in_(in), name_(std::move(name)), resolve_([&variables](Role, const std::string& variable, const auto& value) {
        const auto known = variables.find(variable);
        const automata::VariableId id = known ? *known : variables.add({variable, {}});
        return Assignment{id, variables.add_value(id, value)};
      }) {}

std::optional<LogLine> LogReader::next() {
  for (std::string text; std::getline(in_, text);) {
    ++number_;
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      LogLine line;
      line.number = number_;
      line.time = line.before = last_time_;
      interpret(text, line);
      place(line, !begun_);
      begun_ = true;
      last_time_ = line.time;
      last_cycle_ = line.cycle;
      return line;
    } catch (const base::InputError& error) {
      throw base::InputError(name_ + ":" + std::to_string(number_) + ":" + error.what());
    }
  }
  if (in_.bad()) throw base::InputError(name_ + ": cannot be read");
  return std::nullopt;
}

/// Whether the line can follow the one before it.
void LogReader::place(LogLine& line, bool first) const {
  if (line.time < line.before) {
    throw base::InputError(" the time " + automata::format_seconds(line.time) +
                           " s lies before that of an earlier line, " + automata::format_seconds(line.before) + " s");
  }
  if (line.unchanged == 0) return;
  if (first) throw base::InputError(" 'unchanged': expected a line before it that the cycles left out are like");
  if (last_cycle_ && line.cycle && (*line.cycle <= *last_cycle_ || *line.cycle - *last_cycle_ - 1 != line.unchanged)) {
    throw base::InputError(" 'unchanged': " + std::to_string(line.unchanged) +
                           " cycles cannot have been left out between cycle " + std::to_string(*last_cycle_) +
                           " and cycle " + std::to_string(*line.cycle));
  }
  const auto span = static_cast<std::uint64_t>((line.time - line.before).count);
  if (line.unchanged >= span) {
    throw base::InputError(" 'unchanged': " + std::to_string(line.unchanged) +
                           " cycles cannot have been left out between " + automata::format_seconds(line.before) +
                           " s and " + automata::format_seconds(line.time) + " s");
  }
}

void LogReader::interpret(const std::string& text, LogLine& line) const {
  static const std::vector<std::string_view> keys{
      "cycle",  "time",         "unchanged", "marking",      "goal",    "asserted_by", "command",
      "reason", "observations", "estimate",  "evidence",     "belief",  "truth",       "events",
      "clocks", "cut",          "checked",   "missing_mass", "dropped", "history",     "revised"};
  const Json json = parse_object(text);
  for (const auto& [key, value] : json.items()) {
    if (key == "cycle") {
      line.cycle = count_of(key, value);
    } else if (key == "unchanged") {
      line.unchanged = count_of(key, value);
    } else if (key == "time") {
      line.time = time_of(text, value);
      line.timed = true;
    } else if (key == "command") {
      line.command = assignments(Role::command, key, value);
      line.commanded = true;
    } else if (key == "observations") {
      line.observations = assignments(Role::observations, key, value);
    } else if (key == "estimate") {
      line.estimate = assignments(Role::estimate, key, value);
    } else if (key == "goal" || key == "asserted_by" || key == "reason" || key == "truth" || key == "clocks") {
      expect(value.is_object(), key, "an object", value);
    } else if (key == "marking" || key == "evidence" || key == "belief" || key == "events" || key == "history" ||
               key == "revised") {
      expect(value.is_array(), key, "an array", value);
    } else if (key == "cut") {
      expect(value.is_boolean(), key, "true or false", value);
    } else if (key == "checked" || key == "dropped" || key == "missing_mass") {
      expect(value.is_number(), key, "a number", value);
    } else {
      throw base::InputError(" unknown key '" + key + "'" + base::suggestion(key, keys));
    }
  }
}

std::vector<Assignment> LogReader::assignments(Role role, const std::string& key, const Json& json) const {
  expect(json.is_object(), key, "an object of names and values", json);
  std::vector<Assignment> result;
  const std::string prefix = key + ".";
  for (const auto& [name, value] : json.items()) {
    expect(value.is_string(), prefix + name, "a value as a string", value);
    result.push_back(resolve_(role, name, value.get_ref<const std::string&>()));
  }
  std::sort(result.begin(), result.end());
  return result;
}

namespace {

std::vector<LogLine> all_of(LogReader reader) {
  std::vector<LogLine> lines;
  while (auto line = reader.next()) lines.push_back(*std::move(line));
  return lines;
}

}  // namespace

std::vector<LogLine> read_log(std::istream& in, const std::string& name, const automata::Plant& plant) {
  return all_of({in, name, plant});
}

std::vector<LogLine> read_log(std::istream& in, const std::string& name, automata::Variables& variables) {
  return all_of({in, name, variables});
}

}  // namespace rmpl::runtime
