// Reads JSON Lines, strictly.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/log.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

#include "automata/json/parse.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;
using automata::Json;
using automata::Ticks;
using base::InputError;

enum class Role { estimate, command, observations };

/// Turns a name and a value into an assignment; the text thrown by it is prefixed with file and line by the reader.
using Resolve = std::function<Assignment(Role role, const std::string& name, const std::string& value)>;

/// What a value is, for messages: of a number, the number itself.
std::string name_of(const Json& json) {
  if (json.is_number()) return json.dump();
  return json.is_null() ? "null" : json.type_name();
}

/// Parses one line.
Json parse_object(const std::string& text) {
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

class LogReader {
 public:
  LogReader(std::istream& in, const std::string& name, Resolve resolve)
      : in_(in), name_(name), resolve_(std::move(resolve)) {}

  std::vector<LogLine> read() {
    std::vector<LogLine> lines;
    std::string text;
    Ticks last;
    for (std::size_t number = 1; std::getline(in_, text); ++number) {
      if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
      try {
        LogLine& line = lines.emplace_back();
        line.number = number;
        line.time = last;
        if (text.find('\0') != std::string::npos) throw base::InputError(" expected text, found a NUL byte");
        interpret(parse_object(text), line);
        if (line.time < last) {
          throw base::InputError(" the time " + automata::format_seconds(line.time) +
                                 " s lies before that of an earlier line, " + automata::format_seconds(last) + " s");
        }
        last = line.time;
      } catch (const base::InputError& error) {
        throw base::InputError(located(number, error.what()));
      }
    }
    if (in_.bad()) throw base::InputError(name_ + ": cannot be read");
    return lines;
  }

 private:
  [[nodiscard]] std::string located(std::size_t number, std::string_view message) const {
    return name_ + ":" + std::to_string(number) + ":" + std::string(message);
  }

  static void expect(bool right, const std::string& key, const std::string& expected, const Json& json) {
    if (!right) throw base::InputError(" '" + key + "': expected " + expected + ", not " + name_of(json));
  }

  static Ticks time_of(const Json& json) {
    std::optional<Ticks> time;
    if (json.is_number()) time = automata::ticks_from_seconds(json.get<double>());
    if (json.is_string()) time = automata::parse_duration(json.get_ref<const std::string&>());
    if (!time || time->is_infinite()) {
      throw base::InputError(" 'time': expected seconds from 0 to 9.2e9, or a duration with a unit" +
                             (json.is_string() ? "" : ", not " + name_of(json)));
    }
    return *time;
  }

  void interpret(const Json& json, LogLine& line) const {
    static constexpr std::array<std::string_view, 14> keys{
        "cycle",  "time",  "marking", "goal",   "command", "observations", "estimate",
        "belief", "truth", "events",  "clocks", "cut",     "checked",      "missing_mass"};
    for (const auto& [key, value] : json.items()) {
      if (key == "cycle") {
        expect(value.is_number_unsigned(), key, "a whole number", value);
        line.cycle = value.get<std::uint64_t>();
      } else if (key == "time") {
        line.time = time_of(value);
      } else if (key == "command") {
        line.command = assignments(Role::command, key, value);
      } else if (key == "observations") {
        line.observations = assignments(Role::observations, key, value);
      } else if (key == "estimate") {
        line.estimate = assignments(Role::estimate, key, value);
      } else if (key == "goal" || key == "truth" || key == "clocks") {
        expect(value.is_object(), key, "an object", value);
      } else if (key == "marking" || key == "belief" || key == "events") {
        expect(value.is_array(), key, "an array", value);
      } else if (key == "cut") {
        expect(value.is_boolean(), key, "true or false", value);
      } else if (key == "checked" || key == "missing_mass") {
        expect(value.is_number(), key, "a number", value);
      } else {
        throw base::InputError(" unknown key '" + key + "'" +
                               base::suggestion(key, std::vector<std::string_view>(keys.begin(), keys.end())));
      }
    }
  }

  [[nodiscard]] std::vector<Assignment> assignments(Role role, const std::string& key, const Json& json) const {
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

  std::istream& in_;
  const std::string& name_;
  Resolve resolve_;
};

/// The names that make sense in a role, in declaration order.
std::vector<std::string_view> candidates(const automata::Plant& plant, Role role) {
  std::vector<std::string_view> names;
  switch (role) {
    case Role::command:
      for (const automata::Control& control : plant.controls)
        names.emplace_back(plant.variables.name(control.variable));
      break;
    case Role::estimate:
      for (const automata::Component& component : plant.components) names.emplace_back(component.name);
      break;
    case Role::observations:
      for (const automata::Variable& variable : plant.variables) {
        if (!plant.find_component(variable.name)) names.emplace_back(variable.name);
      }
      break;
  }
  return names;
}

std::string_view noun(Role role) {
  switch (role) {
    case Role::command:
      return "control variable";
    case Role::estimate:
      return "component";
    case Role::observations:
      return "variable";
  }
  return {};
}

/// Whether a variable makes sense in a role.
bool plays(const automata::Plant& plant, Role role, automata::VariableId variable) {
  switch (role) {
    case Role::command:
      return std::any_of(plant.controls.begin(), plant.controls.end(),
                         [&](const automata::Control& control) { return control.variable == variable; });
    case Role::estimate:
      return plant.component_of(variable).has_value();
    case Role::observations:
      return !plant.component_of(variable);
  }
  return false;
}

Assignment resolve(const automata::Plant& plant, Role role, const std::string& name, const std::string& value) {
  const auto variable = plant.variables.find(name);
  if (role == Role::observations && variable && plant.component_of(*variable)) {
    throw base::InputError(" '" + name + "' is a component: no sensor reads its mode; expected an attribute");
  }
  if (!variable || !plays(plant, role, *variable)) {
    throw base::InputError(" '" + name + "' is no " + std::string(noun(role)) + " of plant '" + plant.name + "'" +
                           base::suggestion(name, candidates(plant, role)));
  }
  const automata::Variable& declared = plant.variables[*variable];
  const auto known = declared.find(value);
  if (!known) {
    throw base::InputError(" '" + value + "' is no value of '" + name + "'" + base::suggestion(value, declared.values));
  }
  return {*variable, *known};
}

}  // namespace

std::vector<LogLine> read_log(std::istream& in, const std::string& name, const automata::Plant& plant) {
  return LogReader(in, name,
                   [&plant](Role role, const std::string& variable, const std::string& value) {
                     return resolve(plant, role, variable, value);
                   })
      .read();
}

std::vector<LogLine> read_log(std::istream& in, const std::string& name, automata::Variables& variables) {
  return LogReader(in, name,
                   [&variables](Role, const std::string& variable, const std::string& value) {
                     const auto known = variables.find(variable);
                     const automata::VariableId id = known ? *known : variables.add({variable, {}});
                     return Assignment{id, variables.add_value(id, value)};
                   })
      .read();
}

}  // namespace rmpl::runtime
