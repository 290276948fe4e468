// Model programs as JSON, and back.
// SPDX-License-Identifier: MIT
#include "automata/json/model_json.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "automata/json/condition_json.hpp"
#include "automata/json/location_json.hpp"

namespace rmpl::automata {
namespace {

/// Probabilities of what excludes each other sum to 1 up to this.
constexpr double tolerance = 1e-9;

Json numbers_of(const std::vector<LocationId>& locations) {
  Json json = Json::array();
  for (const LocationId location : locations) json.push_back(location.value + 1);
  return json;
}

Json arcs_to_json(const std::vector<GuardedArc>& arcs, const ModelProgram& model) {
  Json json = Json::array();
  for (const GuardedArc& arc : arcs) {
    Json item;
    for (const Condition& condition : arc.guard) item["guard"].push_back(condition_to_json(condition, model.variables));
    item["target"] = arc.target.value + 1;
    json.push_back(std::move(item));
  }
  return json;
}

Json location_to_json(const ModelLocation& location, std::size_t number, const ModelProgram& model) {
  Json json = object_with_room(9);
  json["number"] = number;
  json["kind"] = location.composite ? "composite" : "primitive";
  if (location.parent) json["parent"] = location.parent->value + 1;
  json["start"] = location.start;
  if (!location.told.is_true()) json["told"] = to_json(location.told, model.variables);
  if (!location.maintenance.is_trivial()) json["maintain"] = condition_to_json(location.maintenance, model.variables);
  if (location.composite) {
    json["arcs"] = arcs_to_json(location.arcs, model);
  } else {
    json["functions"] = Json::array();
    for (const TransitionFunction& function : location.functions) {
      Json item{{"probability", function.probability}};
      if (!function.started.empty()) item["started"] = numbers_of(function.started);
      item["arcs"] = arcs_to_json(function.arcs, model);
      json["functions"].push_back(std::move(item));
    }
  }
  json["label"] = location.label;
  json["origin"] = to_json(location.origin);
  return json;
}

/// Reads a model program; numbers of locations are checked against how many there are.
class Reading {
 public:
  explicit Reading(const Node& node) : node_(node), locations_(node.at("locations").items()) {
    node.only({"name", "variables", "controls", "observables", "constraints", "locations", "initial", "origin"});
    if (locations_.empty()) node.at("locations").fail("at least one location");
  }

  ModelProgram run() {
    model_.name = node_.at("name").text();
    model_.variables = variables_from_json(node_.at("variables"));
    for (const Node& item : node_.at("variables").items()) {
      if (item.at("values").items().empty()) item.at("values").fail("at least one value");
    }
    read_declarations();
    for (std::size_t l = 0; l < locations_.size(); ++l) model_.locations.push_back(location(locations_[l], l));
    for (std::size_t l = 0; l < locations_.size(); ++l) check_started(l);
    for (const Node& item : node_.at("initial").items()) read_initial(item);
    model_.origin = origin_from_json(node_.at("origin"));
    return std::move(model_);
  }

 private:
  VariableId variable(const Node& node) const {
    const auto id = model_.variables.find(node.text());
    if (!id) node.fail("the name of a variable, not '" + node.text() + "'");
    return *id;
  }

  void read_declarations() {
    std::set<VariableId> commanded, observed;
    for (const Node& item : node_.at("controls").items()) {
      item.only({"variable", "idle"});
      CommandedVariable control{variable(item.at("variable")), {}};
      if (!commanded.insert(control.variable).second) item.at("variable").fail("a variable that is new");
      if (item.has("idle")) {
        control.idle = model_.variables[control.variable].find(item.at("idle").text());
        if (!control.idle) item.at("idle").fail("a value of '" + model_.variables.name(control.variable) + "'");
      }
      model_.controls.push_back(control);
    }
    for (const Node& item : node_.at("observables").items()) {
      const VariableId observable = variable(item);
      if (!observed.insert(observable).second) item.fail("a variable that is new");
      model_.observables.push_back(observable);
    }
    for (const Node& item : node_.at("constraints").items()) {
      item.only({"constraint", "origin"});
      model_.constraints.emplace_back(formula_from_json(item.at("constraint"), model_.variables),
                                      origin_from_json(item.at("origin")));
    }
  }

  LocationId number(const Node& node) const {
    const std::size_t number = node.index(locations_.size() + 1);
    if (number == 0) node.fail("the number of a location, from 1");
    return LocationId(number - 1);
  }

  std::vector<LocationId> numbers(const Node& node) const {
    std::vector<LocationId> result;
    for (const Node& item : node.items()) {
      const LocationId id = number(item);
      if (!result.empty() && !(result.back() < id)) item.fail("numbers of locations in order, each once");
      result.push_back(id);
    }
    return result;
  }

  std::vector<GuardedArc> arcs(const Node& node) const {
    std::vector<GuardedArc> result;
    for (const Node& item : node.items()) {
      item.only({"guard", "target"});
      GuardedArc arc;
      if (item.has("guard")) {
        for (const Node& condition : item.at("guard").items())
          arc.guard.push_back(condition_from_json(condition, model_.variables));
      }
      arc.target = number(item.at("target"));
      result.push_back(std::move(arc));
    }
    return result;
  }

  ModelLocation location(const Node& node, std::size_t position) const {
    ModelLocation location = common_of_location(node, position, model_.locations);
    if (location.composite) {
      node.only({"number", "kind", "parent", "start", "maintain", "arcs", "label", "origin"});
      if (node.has("maintain")) location.maintenance = condition_from_json(node.at("maintain"), model_.variables);
      location.arcs = arcs(node.at("arcs"));
    } else {
      node.only({"number", "kind", "parent", "start", "told", "functions", "label", "origin"});
      if (node.has("told")) location.told = formula_from_json(node.at("told"), model_.variables);
      location.functions = functions(node.at("functions"));
    }
    location.label = node.at("label").text();
    location.origin = origin_from_json(node.at("origin"));
    return location;
  }

  std::vector<TransitionFunction> functions(const Node& node) const {
    std::vector<TransitionFunction> result;
    double sum = 0;
    for (const Node& item : node.items()) {
      item.only({"probability", "started", "arcs"});
      TransitionFunction function;
      function.probability = item.at("probability").probability();
      if (item.has("started")) function.started = numbers(item.at("started"));
      function.arcs = arcs(item.at("arcs"));
      sum += function.probability;
      result.push_back(std::move(function));
    }
    if (std::abs(sum - 1) > tolerance) node.fail("probabilities that sum to 1");
    return result;
  }

  /// What a branch starts is primitive and draws nothing.
  void check_started(std::size_t position) const {
    const auto& functions = model_.locations[position].functions;
    for (std::size_t f = 0; f < functions.size(); ++f) {
      for (std::size_t s = 0; s < functions[f].started.size(); ++s) {
        const ModelLocation& started = model_.locations[functions[f].started[s].index()];
        if (!started.composite && started.functions.size() == 1 && started.functions.front().started.empty()) continue;
        locations_[position]
            .at("functions")
            .items()[f]
            .at("started")
            .items()[s]
            .fail("the number of a primitive location with one function, which starts nothing");
      }
    }
  }

  void read_initial(const Node& node) {
    node.only({"choice", "branches"});
    InitialDraw draw{number(node.at("choice")), {}};
    const bool after = model_.initial.empty() || model_.initial.back().choice < draw.choice;
    if (!after || model_.locations[draw.choice.index()].composite || model_.locations[draw.choice.index()].start)
      node.at("choice").fail("a primitive location that is no start, in order");
    double sum = 0;
    for (const Node& item : node.at("branches").items()) {
      item.only({"probability", "started"});
      draw.branches.push_back({item.at("probability").probability(), numbers(item.at("started"))});
      sum += draw.branches.back().probability;
    }
    if (std::abs(sum - 1) > tolerance) node.at("branches").fail("probabilities that sum to 1");
    model_.initial.push_back(std::move(draw));
  }

  const Node& node_;
  std::vector<Node> locations_;
  ModelProgram model_;
};

}  // namespace

Json to_json(const ModelProgram& model) {
  Json controls = Json::array();
  for (const CommandedVariable& control : model.controls) {
    Json item{{"variable", model.variables.name(control.variable)}};
    if (control.idle) item["idle"] = model.variables.value({control.variable, *control.idle});
    controls.push_back(std::move(item));
  }
  Json observables = Json::array();
  for (const VariableId observable : model.observables) observables.push_back(model.variables.name(observable));
  Json constraints = Json::array();
  for (const Interconnection& standing : model.constraints) {
    constraints.push_back(
        {{"constraint", to_json(standing.constraint, model.variables)}, {"origin", to_json(standing.origin)}});
  }
  Json locations = Json::array();
  for (std::size_t l = 0; l < model.locations.size(); ++l)
    locations.push_back(location_to_json(model.locations[l], l + 1, model));
  Json initial = Json::array();
  for (const InitialDraw& draw : model.initial) {
    Json branches = Json::array();
    for (const InitialBranch& branch : draw.branches)
      branches.push_back({{"probability", branch.probability}, {"started", numbers_of(branch.started)}});
    initial.push_back({{"choice", draw.choice.value + 1}, {"branches", std::move(branches)}});
  }
  Json json{{"name", model.name},
            {"variables", to_json(model.variables)},
            {"controls", std::move(controls)},
            {"observables", std::move(observables)},
            {"constraints", std::move(constraints)},
            {"locations", std::move(locations)},
            {"initial", std::move(initial)},
            {"origin", to_json(model.origin)}};
  return json;
}

ModelProgram model_program_from_json(const Node& node) { return Reading(node).run(); }

}  // namespace rmpl::automata
