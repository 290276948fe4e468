// A line an item, events in order of time.
// SPDX-License-Identifier: MIT
#include "runtime/executive/step/scenario_text.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "automata/assignment_text.hpp"
#include "automata/logic/formula.hpp"

namespace rmpl::runtime {
namespace {

using automata::Ticks;

std::string seconds(Ticks time) { return automata::format_seconds(time) + " s"; }
std::string for_so_long(Ticks duration) { return duration.is_infinite() ? "" : " for " + seconds(duration); }

/// As the language writes a text.
std::string quoted_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return quoted + '"';
}

std::string part(const char* word, const std::string& path, const std::string& main, const char* rest) {
  return std::string("  ") + word + " \"" + path + "\"" + (main.empty() ? "" : " main " + main) + rest + ";\n";
}

}  // namespace

std::string scenario_text(const automata::Scenario& scenario, const automata::Plant& plant,
                          const ScenarioPlaces& places) {
  const automata::Variables& variables = plant.variables;
  std::string text = "scenario \"" + scenario.name + "\" {\n";
  text += part("program", places.program, places.program_main, "");
  text += part("plant", places.plant, places.plant_main, scenario.rules_only ? " rules only" : "");
  text += "  cycle " + seconds(scenario.cycle) + ";\n  duration " + seconds(scenario.duration) + ";\n";
  if (!scenario.rules_only) text += "  seed " + std::to_string(scenario.seed) + ";\n";
  if (!scenario.truth.empty()) text += "  truth " + to_text(variables, scenario.truth) + ";\n";
  std::vector<std::pair<Ticks, std::string>> events;
  for (const automata::SensorOverride& o : scenario.overrides) {
    events.emplace_back(o.at, "observe " + to_text(variables, o.reading) + for_so_long(o.duration));
  }
  for (const automata::ChannelSample& s : scenario.samples) {
    events.emplace_back(s.at, "channel " + quoted_text(s.channel) + " = " + (s.number ? s.text : quoted_text(s.text)));
  }
  for (const automata::ForcedMode& f : scenario.forced) {
    events.emplace_back(f.at, "fault " + (f.told ? to_text(variables, *f.told) : to_text(plant[f.component], f.mode)));
  }
  for (const automata::GivenCommand& c : scenario.commands) {
    const bool once = c.duration == scenario.cycle;
    events.emplace_back(c.at, "command " + to_text(variables, c.command) + (once ? "" : for_so_long(c.duration)));
  }
  std::stable_sort(events.begin(), events.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  if (!events.empty()) text += "\n";
  for (const auto& [at, event] : events) text += "  at " + seconds(at) + " " + event + ";\n";
  if (!scenario.rules.empty()) text += "\n";
  for (const automata::Rule& rule : scenario.rules) {
    text += std::string("  when ") + (rule.stream == automata::Rule::Stream::command ? "command " : "estimate ") +
            to_text(rule.trigger, variables);
    text += " after " + (rule.delay ? seconds(*rule.delay) : std::to_string(rule.delay_cycles) + " cycles");
    text += " observe " + to_text(variables, rule.reading) + for_so_long(rule.duration) + ";\n";
  }
  if (!scenario.expectations.empty()) text += "\n";
  for (const automata::Expectation& e : scenario.expectations) text += "  expect " + e.text + ";\n";
  return text + "}\n";
}

}  // namespace rmpl::runtime
