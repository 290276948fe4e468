// Components as JSON, and back.
// SPDX-License-Identifier: MIT
#include "automata/json/component_json.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "automata/json/document.hpp"

namespace rmpl::automata {
namespace {

constexpr std::array<std::pair<Density::Kind, const char*>, 5> densities{{{Density::Kind::uniform, "uniform"},
                                                                          {Density::Kind::exponential, "exponential"},
                                                                          {Density::Kind::normal, "normal"},
                                                                          {Density::Kind::weibull, "weibull"},
                                                                          {Density::Kind::erlang, "erlang"}}};
constexpr double most_stages = 100;

Json timing_to_json(const Timing& timing) {
  Json json{{"lower", to_json(timing.lower)}, {"upper", to_json(timing.upper)}};
  for (const auto& [kind, name] : densities) {
    if (kind == timing.density.kind) json["density"] = name;
  }
  switch (timing.density.kind) {
    case Density::Kind::uniform:
      break;
    case Density::Kind::exponential:
      json["mean"] = timing.density.mean;
      break;
    case Density::Kind::normal:
      json["mean"] = timing.density.mean;
      json["standard_deviation"] = timing.density.standard_deviation;
      break;
    case Density::Kind::weibull:
      json["shape"] = timing.density.shape;
      json["scale"] = timing.density.scale;
      break;
    case Density::Kind::erlang:
      json["shape"] = timing.density.shape;
      json["mean"] = timing.density.mean;
      break;
  }
  return json;
}

Timing timing_from_json(const Node& node) {
  Timing timing{node.at("lower").ticks(), node.at("upper").ticks(), {}};
  const std::string name = node.at("density").text();
  bool known = false;
  for (const auto& [kind, spelling] : densities) {
    if (name != spelling) continue;
    timing.density.kind = kind;
    known = true;
  }
  if (!known) node.at("density").fail("uniform, exponential, normal, weibull or erlang");
  const auto positive = [&](const char* key) {
    const double value = node.at(key).number();
    if (!(value > 0)) node.at(key).fail("a number above 0");
    return value;
  };
  switch (timing.density.kind) {
    case Density::Kind::uniform:
      node.only({"lower", "upper", "density"});
      break;
    case Density::Kind::exponential:
      node.only({"lower", "upper", "density", "mean"});
      timing.density.mean = positive("mean");
      break;
    case Density::Kind::normal:
      node.only({"lower", "upper", "density", "mean", "standard_deviation"});
      timing.density.mean = node.at("mean").number();
      timing.density.standard_deviation = positive("standard_deviation");
      break;
    case Density::Kind::weibull:
      node.only({"lower", "upper", "density", "shape", "scale"});
      timing.density.shape = positive("shape");
      timing.density.scale = positive("scale");
      break;
    case Density::Kind::erlang:
      node.only({"lower", "upper", "density", "shape", "mean"});
      timing.density.shape = positive("shape");
      timing.density.mean = positive("mean");
      if (timing.density.shape > most_stages || timing.density.shape != std::floor(timing.density.shape)) {
        node.at("shape").fail("a whole number from 1 to 100");
      }
      break;
  }
  if (timing.lower > timing.upper || timing.lower.is_infinite()) node.fail("lower <= upper, lower finite");
  return timing;
}

Json transition_to_json(const Transition& t, const Component& component, const Variables& variables) {
  Json json = object_with_room(9);
  json["from"] = component.modes[t.from.index()].name;
  json["to"] = component.modes[t.to.index()].name;
  if (!t.guard.is_true()) json["guard"] = to_json(t.guard, variables);
  if (t.timing) json["timing"] = timing_to_json(*t.timing);
  if (t.weight.kind == Weight::Kind::probability) json["probability"] = t.weight.value;
  if (t.weight.kind == Weight::Kind::rate) json["rate"] = t.weight.value;
  if (t.restart) json["restart"] = true;
  if (t.consequence) json["consequence"] = true;
  json["branch"] = t.branch;
  json["origin"] = to_json(t.origin);
  return json;
}

ModeId mode_from_json(const Node& node, const Component& component) {
  const std::string& name = node.text();
  for (std::size_t m = 0; m < component.modes.size(); ++m) {
    if (component.modes[m].name == name) return ModeId(m);
  }
  node.fail("a mode of '" + component.name + "', not '" + name + "'");
}

Transition transition_from_json(const Node& node, const Component& component, const Variables& variables) {
  node.only({"from", "to", "guard", "timing", "probability", "rate", "restart", "consequence", "branch", "origin"});
  Transition t;
  t.from = mode_from_json(node.at("from"), component);
  t.to = mode_from_json(node.at("to"), component);
  if (node.has("guard")) t.guard = formula_from_json(node.at("guard"), variables);
  if (!is_of_states(t.guard)) node.at("guard").fail("a guard without clocks or knowledge");
  if (node.has("timing")) t.timing = timing_from_json(node.at("timing"));
  if (node.has("probability") && node.has("rate")) node.fail("a probability or a rate, not both");
  if (node.has("probability")) t.weight = {Weight::Kind::probability, node.at("probability").probability()};
  if (node.has("rate")) t.weight = {Weight::Kind::rate, node.at("rate").number()};
  if (node.has("consequence")) t.consequence = node.at("consequence").truth();
  if (node.has("restart")) t.restart = node.at("restart").truth();
  if (t.restart && (t.from != t.to || t.timing || t.weight.kind == Weight::Kind::rate)) {
    node.at("restart").fail("a restart from a mode to itself, without timing and rate");
  }
  if (t.weight.value < 0) node.at("rate").fail("a rate of at least 0");
  if (component.is_fault(t) && t.weight.kind == Weight::Kind::none) node.fail("a probability or a rate: it is a fault");
  if (!component.is_fault(t) && t.weight.kind == Weight::Kind::rate) node.at("rate").fail("a rate on faults only");
  if (!component.is_fault(t) && t.timing && t.timing->lacks_density()) {
    node.at("timing").fail("a density other than uniform where the upper bound is infinite");
  }
  t.branch = static_cast<std::uint32_t>(node.at("branch").index(1u << 31));
  t.origin = origin_from_json(node.at("origin"));
  return t;
}

}  // namespace

Json component_to_json(const Component& component, const Variables& variables) {
  Json modes = Json::array();
  for (const Mode& mode : component.modes) {
    Json& json = modes.emplace_back(object_with_room(6));
    json["name"] = mode.name;
    if (mode.fault) json["fault"] = true;
    if (!mode.constraint.is_true()) json["constraint"] = to_json(mode.constraint, variables);
    if (mode.reward != 0) json["reward"] = mode.reward;
    if (mode.usual) json["usual"] = component.modes[mode.usual->index()].name;
    json["origin"] = to_json(mode.origin);
  }
  Json transitions = Json::array();
  for (const Transition& t : component.transitions) {
    transitions.push_back(transition_to_json(t, component, variables));
  }
  Json json = object_with_room(8);
  json["name"] = component.name;
  json["type"] = component.type;
  json["modes"] = std::move(modes);
  json["initial"] = component.initial;
  json["transitions"] = std::move(transitions);
  if (component.progress) json["progress"] = true;
  if (component.software) json["software"] = true;
  json["origin"] = to_json(component.origin);
  return json;
}

std::vector<double> initial_from_json(const Node& node, const Component& component) {
  std::vector<double> initial;
  double sum = 0;
  for (const Node& item : node.items()) {
    initial.push_back(item.probability());
    sum += initial.back();
  }
  if (initial.size() != component.modes.size()) node.fail("a probability for each mode");
  if (std::abs(sum - 1) > 1e-9) node.fail("probabilities that sum to 1");
  return initial;
}

Component component_from_json(const Node& node, const Variables& variables) {
  node.only({"name", "type", "modes", "initial", "transitions", "progress", "software", "origin"});
  Component component;
  component.name = node.at("name").text();
  component.type = node.at("type").text();
  const auto mode_variable = variables.find(component.name);
  if (!mode_variable) node.at("name").fail("the name of a variable: a component is its mode variable");
  component.mode = *mode_variable;
  const auto& names = variables[component.mode].values;
  for (const Node& item : node.at("modes").items()) {
    item.only({"name", "fault", "constraint", "reward", "usual", "origin"});
    Mode mode;
    mode.name = item.at("name").text();
    mode.fault = item.has("fault") && item.at("fault").truth();
    if (item.has("constraint")) mode.constraint = formula_from_json(item.at("constraint"), variables);
    if (!is_of_states(mode.constraint)) item.at("constraint").fail("a constraint without clocks or knowledge");
    if (item.has("reward")) mode.reward = item.at("reward").number();
    if (item.has("usual")) mode.usual = mode_from_json(item.at("usual"), component);
    mode.origin = origin_from_json(item.at("origin"));
    if (component.modes.size() >= names.size() || names[component.modes.size()] != mode.name) {
      item.at("name").fail("the modes in the order of the values of '" + component.name + "'");
    }
    component.modes.push_back(std::move(mode));
  }
  if (component.modes.size() != names.size())
    node.at("modes").fail("a mode for each value of '" + component.name + "'");
  component.initial = initial_from_json(node.at("initial"), component);
  for (const Node& item : node.at("transitions").items()) {
    component.transitions.push_back(transition_from_json(item, component, variables));
  }
  component.progress = node.has("progress") && node.at("progress").truth();
  component.software = node.has("software") && node.at("software").truth();
  component.origin = origin_from_json(node.at("origin"));
  return component;
}

}  // namespace rmpl::automata
