// A script line by line; a step is told once the next one begins.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/script_log.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "automata/time/checked_ticks.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;

/// What Livingstone2's shell is asked or told beside steps and readings.
constexpr std::array<std::string_view, 24> passed_over{
    "fc",      "scenario", "echo",  "propagate",  "ltms-stats", "cclauses",    "cover",       "prune",
    "explain", "cprops",   "times", "conflict",   "exit",       "assumptions", "oldest-time", "values",
    "cmdt",    "truncate", "wait",  "plan-steps", "obs",        "offassign",   "onassign",    "stats"};

/// Without blanks around the signs of assignments, where they mean nothing.
std::string closed_up(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  std::string result;
  for (const char c : text) {
    if (is_blank(c) && result.ends_with('=')) continue;
    while (c == '=' && !result.empty() && is_blank(result.back())) result.pop_back();
    result += c;
  }
  return result;
}

/// Of two assignments to one variable the later one counts.
void put(std::vector<Assignment>& into, Assignment assignment) {
  std::erase_if(into, [&](const Assignment& known) { return known.variable == assignment.variable; });
  into.insert(std::lower_bound(into.begin(), into.end(), assignment), assignment);
}

}  // namespace

ScriptLog::ScriptLog(std::istream& in, std::string name, const automata::Plant& plant, automata::Ticks period)
    : in_(in), name_(std::move(name)), plant_(plant), names_(plant), period_(period) {
  line_.timed = true;
}

void ScriptLog::fail(const std::string& what) const {
  throw base::InputError(name_ + ":" + std::to_string(number_) + ":" + what);
}

std::optional<LogLine> ScriptLog::next() {
  while (!ready_ && !ended_) {
    if (read_line()) continue;
    ended_ = true;
    // What is read at the start is a line of its own where something was read.
    if (line_.commanded || !line_.observations.empty()) ready_ = line_;
  }
  return std::exchange(ready_, std::nullopt);
}

/// Whether there was a line.
bool ScriptLog::read_line() {
  std::string text;
  if (!std::getline(in_, text)) {
    if (in_.bad()) throw base::InputError(name_ + ": cannot be read");
    return false;
  }
  ++number_;
  text.resize(std::min({text.size(), text.find("//"), text.find(';')}));
  std::istringstream words(closed_up(text));
  std::string verb;
  if (!(words >> verb)) return true;
  const bool step = verb == "progress" || verb == "min-progress";
  if (step) {
    if (line_.commanded || !line_.observations.empty()) ready_ = line_;
    const auto time = automata::checked_product(period_, static_cast<std::uint64_t>(++steps_));
    if (!time) fail(" the script takes more steps than there is time");
    LogLine next;
    next.before = line_.time;
    next.time = *time;
    next.timed = next.commanded = true;
    line_ = std::move(next);
  } else if (verb != "assign" && verb != "unassign") {
    if (std::find(passed_over.begin(), passed_over.end(), verb) != passed_over.end()) return true;
    static const std::vector<std::string_view> known{"progress", "assign", "unassign", "fc", "scenario", "echo"};
    fail(" '" + verb + "' is no command of Livingstone2 that has a counterpart here" + base::suggestion(verb, known));
  }
  line_.number = number_;
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (verb == "unassign") {
      const auto variable = plant_.variables.find(word.substr(0, equals));
      std::erase_if(line_.observations, [&](const Assignment& known) { return known.variable == variable; });
      continue;
    }
    if (equals == std::string::npos) fail(" expected an assignment `name=value`, not '" + word + "'");
    const auto role = step ? LogReader::Role::command : LogReader::Role::observations;
    try {
      put(step ? line_.command : line_.observations,
          names_.resolve(role, word.substr(0, equals), word.substr(equals + 1)));
    } catch (const base::InputError& error) {
      fail(error.what());
    }
  }
  return true;
}

}  // namespace rmpl::runtime
