// Scenarios as JSON, and back.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include "automata/controls.hpp"
#include "automata/json/document.hpp"

namespace rmpl::automata {
namespace {

constexpr std::array<std::pair<Expectation::Kind, const char*>, 6> kinds{
    {{Expectation::Kind::eventually, "eventually"},
     {Expectation::Kind::never, "never"},
     {Expectation::Kind::finished, "finished"},
     {Expectation::Kind::never_finished, "never-finished"},
     {Expectation::Kind::goal_conflict, "goal-conflict"},
     {Expectation::Kind::no_plan, "no-plan"}}};

Json rule_to_json(const Rule& rule, const Plant& plant) {
  Json json{{"stream", rule.stream == Rule::Stream::command ? "command" : "estimate"},
            {"trigger", to_json(rule.trigger, plant.variables)}};
  if (rule.delay) {
    json["delay"] = to_json(*rule.delay);
  } else {
    json["delay_cycles"] = rule.delay_cycles;
  }
  json["reading"] = to_json(rule.reading, plant.variables);
  json["duration"] = to_json(rule.duration);
  json["origin"] = to_json(rule.origin);
  return json;
}

/// A reading is of something that the plant shows.
Assignment reading_from_json(const Node& node, const Plant& plant) {
  const Assignment reading = assignment_from_json(node, plant.variables);
  const auto& shown = plant.observables;
  if (std::find(shown.begin(), shown.end(), reading.variable) == shown.end()) node.fail("an observable and its value");
  return reading;
}

/// A command is of a control of the plant.
Assignment command_from_json(const Node& node, const Plant& plant) {
  const Assignment command = assignment_from_json(node, plant.variables);
  if (!is_control(plant, command.variable)) node.fail("a control and its value");
  return command;
}

Rule rule_from_json(const Node& node, const Plant& plant) {
  node.only({"stream", "trigger", node.has("delay") ? "delay" : "delay_cycles", "reading", "duration", "origin"});
  Rule rule;
  const std::string stream = node.at("stream").text();
  if (stream != "command" && stream != "estimate") node.at("stream").fail("command or estimate");
  rule.stream = stream == "command" ? Rule::Stream::command : Rule::Stream::estimate;
  rule.trigger = formula_from_json(node.at("trigger"), plant.variables);
  for (const VariableId v : variables_of(rule.trigger)) {
    if (rule.stream == Rule::Stream::estimate ? plant.component_of(v).has_value() : is_control(plant, v)) continue;
    node.at("trigger").fail(rule.stream == Rule::Stream::estimate ? "modes of components" : "values of controls");
  }
  if (node.has("delay")) {
    rule.delay = node.at("delay").ticks();
  } else {
    rule.delay_cycles = node.at("delay_cycles").natural();
  }
  rule.reading = reading_from_json(node.at("reading"), plant);
  rule.duration = node.at("duration").ticks();
  rule.origin = origin_from_json(node.at("origin"));
  return rule;
}

/// Of a scenario or an expectation, which may have none.
std::vector<std::string> requirements_from_json(const Node& node) {
  std::vector<std::string> tags;
  if (!node.has("requirements")) return tags;
  for (const Node& item : node.at("requirements").items()) {
    tags.push_back(item.text());
    if (tags.back().empty()) item.fail("the name of a requirement");
  }
  return tags;
}

Json expectation_to_json(const Expectation& expectation, const Plant& plant) {
  Json json;
  for (const auto& [kind, name] : kinds) {
    if (kind == expectation.kind) json["kind"] = name;
  }
  json["truth"] = expectation.truth;
  json["condition"] = to_json(expectation.condition, plant.variables);
  if (expectation.after) json["after"] = to_json(*expectation.after, plant.variables);
  if (expectation.within) json["within"] = to_json(*expectation.within);
  json["text"] = expectation.text;
  if (!expectation.requirements.empty()) json["requirements"] = expectation.requirements;
  json["origin"] = to_json(expectation.origin);
  return json;
}

Expectation expectation_from_json(const Node& node, const Plant& plant) {
  node.only({"kind", "truth", "condition", "after", "within", "text", "requirements", "origin"});
  Expectation expectation;
  const std::string name = node.at("kind").text();
  bool known = false;
  for (const auto& [kind, spelling] : kinds) {
    if (name != spelling) continue;
    expectation.kind = kind;
    known = true;
  }
  if (!known) node.at("kind").fail("eventually, never, finished, never-finished, goal-conflict or no-plan");
  expectation.truth = node.at("truth").truth();
  expectation.condition = formula_from_json(node.at("condition"), plant.variables);
  if (node.has("after")) expectation.after = formula_from_json(node.at("after"), plant.variables);
  if (expectation.truth &&
      (has_knowledge(expectation.condition) || (expectation.after && has_knowledge(*expectation.after)))) {
    node.at("truth").fail("false where something is asked of the executive's knowledge");
  }
  if (node.has("within")) expectation.within = node.at("within").ticks();
  expectation.text = node.at("text").text();
  expectation.requirements = requirements_from_json(node);
  expectation.origin = origin_from_json(node.at("origin"));
  return expectation;
}

/// A number is also told as it was written.
ChannelSample sample_from_json(const Node& node) {
  node.only({"at", "channel", "value", "text", "origin"});
  ChannelSample sample;
  sample.at = node.at("at").ticks();
  sample.channel = node.at("channel").text();
  const Node value = node.at("value");
  if (value.json().is_string()) {
    sample.text = value.text();
  } else {
    if (!value.json().is_number()) value.fail("a number or a string");
    sample.number = value.number();
    sample.text = node.at("text").text();
  }
  sample.origin = origin_from_json(node.at("origin"));
  return sample;
}

}  // namespace

Json to_json(const Scenario& scenario, const Document& document) {
  const Plant& plant = document.plant_of(scenario);
  Json truth = Json::array();
  for (const Assignment& a : scenario.truth) truth.push_back(to_json(a, plant.variables));
  Json forced = Json::array();
  for (const ForcedMode& f : scenario.forced) {
    const Assignment mode{plant[f.component].mode, ValueId(f.mode.index())};
    forced.push_back({{"at", to_json(f.at)}, {"mode", to_json(mode, plant.variables)}, {"origin", to_json(f.origin)}});
    if (f.told) forced.back()["told"] = to_json(*f.told, plant.variables);
    for (const ModeId m : f.also) {
      forced.back()["also"].push_back(to_json(Assignment{mode.variable, ValueId(m.index())}, plant.variables));
    }
  }
  Json overrides = Json::array();
  for (const SensorOverride& o : scenario.overrides) {
    overrides.push_back({{"at", to_json(o.at)},
                         {"duration", to_json(o.duration)},
                         {"reading", to_json(o.reading, plant.variables)},
                         {"origin", to_json(o.origin)}});
  }
  Json commands = Json::array();
  for (const GivenCommand& c : scenario.commands) {
    commands.push_back({{"at", to_json(c.at)},
                        {"duration", to_json(c.duration)},
                        {"command", to_json(c.command, plant.variables)},
                        {"origin", to_json(c.origin)}});
  }
  Json samples = Json::array();
  for (const ChannelSample& s : scenario.samples) {
    samples.push_back({{"at", to_json(s.at)},
                       {"channel", s.channel},
                       {"value", s.number ? Json(*s.number) : Json(s.text)},
                       {"origin", to_json(s.origin)}});
    if (s.number) samples.back()["text"] = s.text;
  }
  Json rules = Json::array();
  for (const Rule& rule : scenario.rules) rules.push_back(rule_to_json(rule, plant));
  Json expectations = Json::array();
  for (const Expectation& e : scenario.expectations) expectations.push_back(expectation_to_json(e, plant));
  Json json = {{"name", scenario.name},
               {"program", scenario.program},
               {"plant", scenario.plant},
               {"rules_only", scenario.rules_only},
               {"cycle", to_json(scenario.cycle)},
               {"duration", to_json(scenario.duration)},
               {"seed", scenario.seed},
               {"truth", std::move(truth)},
               {"forced", std::move(forced)},
               {"overrides", std::move(overrides)},
               {"commands", std::move(commands)},
               {"rules", std::move(rules)},
               {"expectations", std::move(expectations)}};
  if (!samples.empty()) json["samples"] = std::move(samples);
  if (!scenario.requirements.empty()) json["requirements"] = scenario.requirements;
  json["origin"] = to_json(scenario.origin);
  return json;
}

Scenario scenario_from_json(const Node& node, const Document& document) {
  node.only({"name", "program", "plant", "rules_only", "cycle", "duration", "seed", "truth", "forced", "overrides",
             "commands", "samples", "rules", "expectations", "requirements", "origin"});
  Scenario scenario;
  scenario.name = node.at("name").text();
  scenario.program = node.at("program").index(document.programs.size());
  scenario.plant = node.at("plant").index(document.plants.size());
  const Plant& plant = document.plant_of(scenario);
  scenario.rules_only = node.at("rules_only").truth();
  scenario.cycle = node.at("cycle").ticks();
  if (scenario.cycle <= Ticks{0} || scenario.cycle.is_infinite()) node.at("cycle").fail("a time above 0");
  scenario.duration = node.at("duration").ticks();
  scenario.seed = node.at("seed").natural();
  const auto mode_of = [&](const Node& item) {
    const Assignment mode = assignment_from_json(item, plant.variables);
    if (!plant.component_of(mode.variable)) item.fail("a component and its mode");
    return mode;
  };
  for (const Node& item : node.at("truth").items()) scenario.truth.push_back(mode_of(item));
  for (const Node& item : node.at("forced").items()) {
    item.only({"at", "mode", "origin", "told", "also"});
    const Assignment mode = mode_of(item.at("mode"));
    ForcedMode& forced = scenario.forced.emplace_back();
    forced = {item.at("at").ticks(), *plant.component_of(mode.variable), ModeId(mode.value.index()),
              origin_from_json(item.at("origin"))};
    if (item.has("told")) forced.told = assignment_from_json(item.at("told"), plant.variables);
    if (!item.has("also")) continue;
    for (const Node& other : item.at("also").items()) {
      const Assignment also = mode_of(other);
      if (also.variable != mode.variable) other.fail("a mode of the same component");
      forced.also.emplace_back(also.value.index());
    }
  }
  for (const Node& item : node.at("overrides").items()) {
    item.only({"at", "duration", "reading", "origin"});
    scenario.overrides.push_back({item.at("at").ticks(), item.at("duration").ticks(),
                                  reading_from_json(item.at("reading"), plant), origin_from_json(item.at("origin"))});
  }
  for (const Node& item : node.at("commands").items()) {
    item.only({"at", "duration", "command", "origin"});
    scenario.commands.push_back({item.at("at").ticks(), item.at("duration").ticks(),
                                 command_from_json(item.at("command"), plant), origin_from_json(item.at("origin"))});
  }
  if (node.has("samples")) {
    for (const Node& item : node.at("samples").items()) scenario.samples.push_back(sample_from_json(item));
  }
  for (const Node& item : node.at("rules").items()) scenario.rules.push_back(rule_from_json(item, plant));
  for (const Node& item : node.at("expectations").items()) {
    scenario.expectations.push_back(expectation_from_json(item, plant));
  }
  scenario.requirements = requirements_from_json(node);
  scenario.origin = origin_from_json(node.at("origin"));
  return scenario;
}

}  // namespace rmpl::automata
