// Plants as JSON, and back.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "automata/json/document.hpp"

namespace rmpl::automata {
namespace {

constexpr std::array<std::pair<Density::Kind, const char*>, 3> densities{{{Density::Kind::uniform, "uniform"},
                                                                          {Density::Kind::exponential, "exponential"},
                                                                          {Density::Kind::normal, "normal"}}};

Json timing_to_json(const Timing& timing) {
  Json json{{"lower", to_json(timing.lower)}, {"upper", to_json(timing.upper)}};
  for (const auto& [kind, name] : densities) {
    if (kind == timing.density.kind) json["density"] = name;
  }
  if (timing.density.kind != Density::Kind::uniform) json["mean"] = timing.density.mean;
  if (timing.density.kind == Density::Kind::normal) json["standard_deviation"] = timing.density.standard_deviation;
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
  if (!known) node.at("density").fail("uniform, exponential or normal");
  switch (timing.density.kind) {
    case Density::Kind::uniform:
      node.only({"lower", "upper", "density"});
      break;
    case Density::Kind::exponential:
      node.only({"lower", "upper", "density", "mean"});
      break;
    case Density::Kind::normal:
      node.only({"lower", "upper", "density", "mean", "standard_deviation"});
      break;
  }
  const auto positive = [&](const char* key) {
    const double value = node.at(key).number();
    if (!(value > 0)) node.at(key).fail("a number above 0");
    return value;
  };
  if (timing.density.kind == Density::Kind::exponential) timing.density.mean = positive("mean");
  if (timing.density.kind == Density::Kind::normal) {
    timing.density.mean = node.at("mean").number();
    timing.density.standard_deviation = positive("standard_deviation");
  }
  if (timing.lower > timing.upper || timing.lower.is_infinite()) node.fail("lower <= upper, lower finite");
  if (timing.upper.is_infinite() && timing.density.kind == Density::Kind::uniform) {
    node.fail("a density other than uniform where the upper bound is infinite");
  }
  return timing;
}

Json transition_to_json(const Transition& t, const Component& component, const Variables& variables) {
  Json json{{"from", component.modes[t.from.index()].name},
            {"to", component.modes[t.to.index()].name},
            {"guard", to_json(t.guard, variables)}};
  if (t.timing) json["timing"] = timing_to_json(*t.timing);
  if (t.weight.kind == Weight::Kind::probability) json["probability"] = t.weight.value;
  if (t.weight.kind == Weight::Kind::rate) json["rate"] = t.weight.value;
  json["branch"] = t.branch;
  json["origin"] = to_json(t.origin);
  return json;
}

Transition transition_from_json(const Node& node, const Component& component, const Variables& variables) {
  node.only({"from", "to", "guard", "timing", "probability", "rate", "branch", "origin"});
  const auto mode = [&](const char* key) {
    const std::string name = node.at(key).text();
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      if (component.modes[m].name == name) return ModeId(m);
    }
    node.at(key).fail("a mode of '" + component.name + "', not '" + name + "'");
  };
  Transition t;
  t.from = mode("from");
  t.to = mode("to");
  t.guard = formula_from_json(node.at("guard"), variables);
  if (has_clock(t.guard)) node.at("guard").fail("a guard without clocks");
  if (node.has("timing")) t.timing = timing_from_json(node.at("timing"));
  if (node.has("probability") && node.has("rate")) node.fail("a probability or a rate, not both");
  if (node.has("probability")) t.weight = {Weight::Kind::probability, node.at("probability").probability()};
  if (node.has("rate")) t.weight = {Weight::Kind::rate, node.at("rate").number()};
  if (t.weight.value < 0) node.at("rate").fail("a rate of at least 0");
  if (component.is_fault(t) && t.weight.kind == Weight::Kind::none) node.fail("a probability or a rate: it is a fault");
  if (!component.is_fault(t) && t.weight.kind == Weight::Kind::rate) node.at("rate").fail("a rate on faults only");
  t.branch = static_cast<std::uint32_t>(node.at("branch").index(1u << 31));
  t.origin = origin_from_json(node.at("origin"));
  return t;
}

Json component_to_json(const Component& component, const Variables& variables) {
  Json modes = Json::array();
  for (const Mode& mode : component.modes) {
    modes.push_back({{"name", mode.name},
                     {"fault", mode.fault},
                     {"constraint", to_json(mode.constraint, variables)},
                     {"reward", mode.reward},
                     {"origin", to_json(mode.origin)}});
  }
  Json transitions = Json::array();
  for (const Transition& t : component.transitions) {
    transitions.push_back(transition_to_json(t, component, variables));
  }
  return {{"name", component.name},
          {"type", component.type},
          {"modes", std::move(modes)},
          {"initial", component.initial},
          {"transitions", std::move(transitions)},
          {"origin", to_json(component.origin)}};
}

Component component_from_json(const Node& node, const Variables& variables) {
  node.only({"name", "type", "modes", "initial", "transitions", "origin"});
  Component component;
  component.name = node.at("name").text();
  component.type = node.at("type").text();
  const auto mode_variable = variables.find(component.name);
  if (!mode_variable) node.at("name").fail("the name of a variable: a component is its mode variable");
  component.mode = *mode_variable;
  const auto& names = variables[component.mode].values;
  for (const Node& item : node.at("modes").items()) {
    item.only({"name", "fault", "constraint", "reward", "origin"});
    Mode mode;
    mode.name = item.at("name").text();
    mode.fault = item.at("fault").truth();
    mode.constraint = formula_from_json(item.at("constraint"), variables);
    if (has_clock(mode.constraint)) item.at("constraint").fail("a constraint without clocks");
    mode.reward = item.at("reward").number();
    mode.origin = origin_from_json(item.at("origin"));
    if (component.modes.size() >= names.size() || names[component.modes.size()] != mode.name) {
      item.at("name").fail("the modes in the order of the values of '" + component.name + "'");
    }
    component.modes.push_back(std::move(mode));
  }
  if (component.modes.size() != names.size())
    node.at("modes").fail("a mode for each value of '" + component.name + "'");
  double sum = 0;
  for (const Node& item : node.at("initial").items()) {
    component.initial.push_back(item.probability());
    sum += component.initial.back();
  }
  if (component.initial.size() != component.modes.size()) node.at("initial").fail("a probability for each mode");
  if (std::abs(sum - 1) > 1e-9) node.at("initial").fail("probabilities that sum to 1");
  for (const Node& item : node.at("transitions").items()) {
    component.transitions.push_back(transition_from_json(item, component, variables));
  }
  component.origin = origin_from_json(node.at("origin"));
  return component;
}

}  // namespace

Json to_json(const Plant& plant) {
  Json components = Json::array();
  for (const Component& component : plant.components) {
    components.push_back(component_to_json(component, plant.variables));
  }
  Json interconnections = Json::array();
  for (const Interconnection& q : plant.interconnections) {
    interconnections.push_back({{"constraint", to_json(q.constraint, plant.variables)}, {"origin", to_json(q.origin)}});
  }
  Json controls = Json::array();
  for (const Control& control : plant.controls) {
    controls.push_back({{"variable", plant.variables.name(control.variable)},
                        {"idle", plant.variables.value({control.variable, control.idle})}});
  }
  Json observables = Json::array();
  for (const VariableId observable : plant.observables) observables.push_back(plant.variables.name(observable));
  return {{"name", plant.name},
          {"variables", to_json(plant.variables)},
          {"components", std::move(components)},
          {"interconnections", std::move(interconnections)},
          {"controls", std::move(controls)},
          {"observables", std::move(observables)}};
}

Plant plant_from_json(const Node& node) {
  node.only({"name", "variables", "components", "interconnections", "controls", "observables"});
  Plant plant;
  plant.name = node.at("name").text();
  plant.variables = variables_from_json(node.at("variables"));
  for (const Node& item : node.at("variables").items()) {
    if (item.at("values").items().empty()) item.at("values").fail("at least one value");
  }
  std::unordered_set<VariableId> modes;
  for (const Node& item : node.at("components").items()) {
    Component component = component_from_json(item, plant.variables);
    if (!modes.insert(component.mode).second) item.at("name").fail("a name that is new");
    plant.components.push_back(std::move(component));
  }
  if (plant.components.empty()) node.at("components").fail("at least one component");
  for (const Node& item : node.at("interconnections").items()) {
    item.only({"constraint", "origin"});
    Formula constraint = formula_from_json(item.at("constraint"), plant.variables);
    if (has_clock(constraint)) item.at("constraint").fail("an interconnection without clocks");
    plant.interconnections.emplace_back(std::move(constraint), origin_from_json(item.at("origin")));
  }
  const auto attribute = [&](const Node& item) {
    const auto id = plant.variables.find(item.text());
    if (!id || modes.contains(*id)) item.fail("the name of an attribute, not '" + item.text() + "'");
    return *id;
  };
  for (const Node& item : node.at("controls").items()) {
    item.only({"variable", "idle"});
    const VariableId variable = attribute(item.at("variable"));
    const auto idle = plant.variables[variable].find(item.at("idle").text());
    if (!idle) item.at("idle").fail("a value of '" + plant.variables.name(variable) + "'");
    plant.controls.push_back({variable, *idle});
  }
  for (const Node& item : node.at("observables").items()) plant.observables.push_back(attribute(item));
  return plant;
}

}  // namespace rmpl::automata
