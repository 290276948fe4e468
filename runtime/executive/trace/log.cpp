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

/// The text of a time; `json` is the value of the key `time` in `text`.
std::string text_of_time(const std::string& text, const Json& json) {
  return json.is_string() ? json.get<std::string>() : json.is_number() ? written(text, "time") : std::string();
}

[[noreturn]] void refuse_gone(const std::string& key, const std::string& name) {
  throw base::InputError(" '" + key + "': there is no '" + name + "' that could be gone");
}

}  // namespace

Ticks LogLine::time_of_unchanged(std::uint64_t cycle_left_out) const {
  __extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): __extension__ wants a typedef
  const Wide share = static_cast<Wide>(time.count - before.count) * static_cast<Wide>(cycle_left_out);
  return {before.count + static_cast<std::int64_t>(share / (static_cast<Wide>(unchanged) + 1))};
}

LogReader::LogReader(std::istream& in, std::string name, const automata::Plant& plant)
    : in_(in),
      name_(std::move(name)),
      resolve_([names = LogNames(plant)](Role role, const std::string& variable, const auto& value) {
        return names.resolve(role, variable, value);
      }),
      find_([&plant](const std::string& variable) { return plant.variables.find(variable); }) {}

LogReader::LogReader(std::istream& in, std::string name, const automata::ModelProgram& program)
    : in_(in),
      name_(std::move(name)),
      resolve_([&program](Role role, const std::string& variable, const auto& value) {
        return resolve(program, role, variable, value);
      }),
      find_([&program](const std::string& variable) { return program.variables.find(variable); }),
      of_markings_(true) {}

LogReader::LogReader(std::istream& in, std::string name, automata::Variables& variables)
    : in_(in),
      name_(std::move(name)),
      resolve_([&variables](Role, const std::string& variable, const auto& value) {
        const auto known = variables.find(variable);
        const automata::VariableId id = known ? *known : variables.add({variable, {}});
        return Assignment{id, variables.add_value(id, value)};
      }),
      find_([&variables](const std::string& variable) { return variables.find(variable); }) {}

void LogReader::read_times(LogTimeOptions options, OddSamples odd) {
  times_ = LogTimes(options);
  odd_ = odd;
}

bool LogReader::get_line(std::string& text) {
  if (ahead_) {
    text = *std::exchange(ahead_, std::nullopt);
    return true;
  }
  return static_cast<bool>(std::getline(in_, text));
}

std::optional<LogLine> LogReader::next() {
  for (std::string text; get_line(text);) {
    ++number_;
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      LogLine line;
      line.number = number_;
      line.time = line.before = last_time_;
      if (!interpret(text, line)) continue;
      place(line, !begun_);
      last_ = line;
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

/// The time of the next line, if it has one that can be read; whatever else it is, is told when its turn comes.
std::optional<TimeText> LogReader::time_ahead() {
  std::string text;
  if (odd_ == OddSamples::refused || !get_line(text)) return std::nullopt;
  ahead_ = text;
  try {
    const Json json = parse_object(text);
    const auto time = json.find("time");
    return time == json.end() ? std::nullopt : read_time_text(text_of_time(text, *time));
  } catch (const base::InputError&) {
    return std::nullopt;
  }
}

/// Whether the line counts: an odd sample may be left out.
bool LogReader::read_time(const std::string& text, const Json& json, bool sample, LogLine& line) {
  const std::string written_time = text_of_time(text, json);
  const auto time = read_time_text(written_time);
  if (!time) {
    throw base::InputError(" 'time': expected seconds, a duration with a unit, a date or a mission time, not " +
                           (written_time.empty() ? name_of(json) : written_time));
  }
  const auto place = times_.place(*time, [this] { return time_ahead(); });
  if (!place) throw base::InputError(" 'time': expected at most 292 years from the start, not " + written_time);
  line.time = place->time;
  line.timed = true;
  if (place->fate == TimeFate::follows) return true;
  if (sample && odd_ == OddSamples::left_out) {
    times_.leave_out(place->fate, line.number);
    return false;
  }
  switch (place->fate) {
    case TimeFate::before_origin:
      throw base::InputError(" 'time': " + written_time + " lies before the start, time 0");
    case TimeFate::wrong_unit:
      throw base::InputError(" 'time': " + written_time + " is in another unit than the times before it");
    default:
      throw base::InputError(" the time " + automata::format_seconds(line.time) +
                             " s lies before that of an earlier line, " + automata::format_seconds(line.before) + " s");
  }
}

/// Whether the line can follow the one before it.
void LogReader::place(LogLine& line, bool first) const {
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

bool LogReader::interpret(const std::string& text, LogLine& line) {
  static const std::vector<std::string_view> keys{
      "cycle",   "time",         "unchanged", "marking",  "goal",         "asserted_by",     "command",
      "reason",  "observations", "set_aside", "estimate", "evidence",     "belief",          "truth",
      "events",  "clocks",       "cut",       "checked",  "missing_mass", "dropped",         "history",
      "revised", "channels",     "delta",     "known",    "left_out",     "goal_constraints"};
  const Json json = parse_object(text);
  const bool delta = is_delta(json, line);
  if (delta && !begun_) return false;  // it begins with the next whole line
  const Json* time = nullptr;
  for (const auto& [key, value] : json.items()) {
    if (key == "cycle") {
      line.cycle = count_of(key, value);
    } else if (key == "unchanged") {
      line.unchanged = count_of(key, value);
    } else if (key == "time") {
      time = &value;
    } else if (key == "delta" || (delta && key == "reason" && value.is_null())) {
      continue;
    } else if (key == "command") {
      assign(Role::command, key, value, delta, line.command);
      line.commanded = true;
    } else if (key == "observations") {
      assign(Role::observations, key, value, delta, line.observations, &line);
    } else if (key == "set_aside") {
      assign(Role::observations, key, value, delta, line.set_aside);
    } else if (key == "channels") {
      expect(value.is_object(), key, "an object of channels and samples", value);
      for (const auto& [name, sample] : value.items()) add_sample(name, sample, line);
    } else if (key == "estimate" && !of_markings_) {
      if (!line.estimate) line.estimate.emplace();
      assign(Role::estimate, key, value, delta, *line.estimate);
    } else if (key == "estimate" || key == "goal" || key == "asserted_by" || key == "reason" || key == "truth" ||
               key == "clocks") {
      expect(value.is_object(), key, "an object", value);
    } else if (key == "known") {
      line.known = names(key, value);
    } else if (key == "left_out" || key == "goal_constraints" || key == "marking" || key == "evidence" ||
               key == "belief" || key == "events" || key == "history" || key == "revised") {
      expect(value.is_array(), key, "an array", value);
    } else if (key == "cut") {
      expect(value.is_boolean(), key, "true or false", value);
    } else if (key == "checked" || key == "dropped" || key == "missing_mass") {
      expect(value.is_number(), key, "a number", value);
    } else {
      const bool passed_over = monitors_ != nullptr && value.is_primitive();
      if (add_sample(key, value, line) || passed_over) continue;
      throw base::InputError(" unknown key '" + key + "'" + base::suggestion(key, keys));
    }
  }
  if (delta && line.cycle && last_cycle_ && *line.cycle > *last_cycle_) {
    line.unchanged = *line.cycle - *last_cycle_ - 1;
  }
  const bool sample =
      !line.commanded && !line.cycle && !line.estimate && !(line.observations.empty() && line.samples.empty());
  if (time != nullptr && !read_time(text, *time, sample, line)) return false;
  if (sample && odd_ == OddSamples::left_out && begun_ && line.time == line.before &&
      std::pair(line.observations, line.samples) == last_sample_) {
    times_.leave_out(TimeFate::repeated, line.number);
    return false;
  }
  last_sample_ = {};
  if (sample && odd_ == OddSamples::left_out) last_sample_ = {line.observations, line.samples};
  return true;
}

std::vector<std::string> LogReader::names(const std::string& key, const Json& json) {
  expect(json.is_array(), key, "an array", json);
  std::vector<std::string> result;
  for (const Json& item : json) {
    expect(item.is_string(), key, "texts", item);
    result.push_back(item.get<std::string>());
  }
  return result;
}

/// Whether the name is that of a channel. Null is no sample.
bool LogReader::add_sample(const std::string& name, const Json& json, LogLine& line) const {
  const auto channel = monitors_ == nullptr ? std::nullopt : monitors_->find(name);
  if (!channel || json.is_null()) return channel.has_value();
  if (json.is_number()) {
    line.samples.push_back(Sample::of_number(*channel, json.get<double>(), json.dump()));
  } else if (json.is_string()) {
    line.samples.push_back(Sample::of_text(*channel, json.get_ref<const std::string&>()));
  } else {
    expect(json.is_boolean(), name, "a number or a text", json);
    line.samples.push_back(Sample::of_text(*channel, json.dump()));
  }
  return true;
}

bool LogReader::is_delta(const Json& json, LogLine& line) const {
  const auto delta = json.find("delta");
  if (delta == json.end()) return false;
  expect(delta->is_boolean(), "delta", "true or false", *delta);
  if (!delta->get<bool>()) return false;
  line.command = last_.command;
  line.commanded = last_.commanded;
  line.observations = last_.observations;
  line.set_aside = last_.set_aside;
  line.estimate = last_.estimate;
  line.known = last_.known;
  return true;
}

/// With a line, names of channels are samples of it. Of changes, null is what is there no longer.
void LogReader::assign(Role role, const std::string& key, const Json& json, bool delta, std::vector<Assignment>& into,
                       LogLine* line) const {
  expect(json.is_object(), key, "an object of names and values", json);
  const std::string prefix = key + ".";
  for (const auto& [name, value] : json.items()) {
    if (line != nullptr && add_sample(name, value, *line)) continue;
    const bool gone = delta && value.is_null();
    if (!gone) expect(value.is_string(), prefix + name, "a value as a string", value);
    if (delta) {
      const auto known = find_(name);
      if (gone && !known) refuse_gone(key, name);
      std::erase_if(into, [&](const Assignment& before) { return before.variable == known; });
    }
    if (!gone) into.push_back(resolve_(role, name, value.get_ref<const std::string&>()));
  }
  std::sort(into.begin(), into.end());
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
