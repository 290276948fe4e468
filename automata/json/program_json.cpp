// Control programs as JSON, and back.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <unordered_set>

#include "automata/json/condition_json.hpp"
#include "automata/json/document.hpp"
#include "automata/json/location_json.hpp"

namespace rmpl::automata {
namespace {

Json location_to_json(const Location& location, std::size_t number, const Program& program) {
  Json json = object_with_room(13);
  json["number"] = number;
  json["kind"] = location.composite ? "composite" : "primitive";
  if (location.parent) json["parent"] = location.parent->value + 1;
  json["start"] = location.start;
  if (location.apart) json["apart"] = true;
  if (!location.goal.empty()) {
    json["goal"] = Json::array();
    for (const Assignment& goal : location.goal) json["goal"].push_back(to_json(goal, program.variables));
  }
  if (!location.goal_constraints.empty()) {
    json["goal_constraints"] = Json::array();
    for (const Formula& constraint : location.goal_constraints)
      json["goal_constraints"].push_back(to_json(constraint, program.variables));
  }
  if (location.clock_start) json["clock_start"] = program.clocks[location.clock_start->index()];
  if (!location.own_clocks.empty()) {
    json["own_clocks"] = Json::array();
    for (const ClockId clock : location.own_clocks) json["own_clocks"].push_back(program.clocks[clock.index()]);
  }
  if (!location.maintenance.is_trivial())
    json["maintain"] = condition_to_json(location.maintenance, program.variables, program.clocks);
  json["arcs"] = Json::array();
  for (const Arc& arc : location.arcs) {
    Json item;
    if (!arc.guard.is_trivial()) item["guard"] = condition_to_json(arc.guard, program.variables, program.clocks);
    item["target"] = arc.target.value + 1;
    json["arcs"].push_back(std::move(item));
  }
  json["label"] = location.label;
  json["origin"] = to_json(location.origin);
  return json;
}

ClockId clock_from_json(const Node& node, const Program& program) {
  const std::string& clock = node.text();
  const auto at = std::find(program.clocks.begin(), program.clocks.end(), clock);
  if (at == program.clocks.end()) node.fail("the name of a clock, not '" + clock + "'");
  return ClockId(static_cast<std::size_t>(at - program.clocks.begin()));
}

/// `owned` holds the clocks that belong to locations so far.
Location location_from_json(const Node& node, std::size_t position, std::size_t count, const Program& program,
                            std::set<ClockId>& owned) {
  node.only({"number", "kind", "parent", "start", "apart", "goal", "goal_constraints", "clock_start", "own_clocks",
             "maintain", "arcs", "label", "origin"});
  Location location = common_of_location(node, position, program.locations);
  location.apart = node.has("apart") && node.at("apart").truth();
  if (location.apart && !location.composite) node.at("apart").fail("a composite to have goals of its own");
  if (node.has("goal")) {
    for (const Node& item : node.at("goal").items()) {
      location.goal.push_back(assignment_from_json(item, program.variables));
    }
  }
  if (node.has("goal_constraints")) {
    for (const Node& item : node.at("goal_constraints").items()) {
      location.goal_constraints.push_back(formula_from_json(item, program.variables));
      if (!is_of_states(location.goal_constraints.back())) item.fail("a constraint without clocks or knowledge");
    }
  }
  if (node.has("clock_start")) location.clock_start = clock_from_json(node.at("clock_start"), program);
  if (node.has("own_clocks")) {
    if (!location.composite) node.at("own_clocks").fail("a composite to have them");
    for (const Node& item : node.at("own_clocks").items()) {
      const ClockId clock = clock_from_json(item, program);
      if (!owned.insert(clock).second) item.fail("a clock that is nobody's own yet");
      location.own_clocks.push_back(clock);
    }
  }
  if (node.has("maintain"))
    location.maintenance = condition_from_json(node.at("maintain"), program.variables, program.clocks);
  for (const Node& item : node.at("arcs").items()) {
    item.only({"guard", "target"});
    Arc arc;
    if (item.has("guard")) arc.guard = condition_from_json(item.at("guard"), program.variables, program.clocks);
    const std::size_t target = item.at("target").index(count + 1);
    if (target == 0) item.at("target").fail("the number of a location, from 1");
    arc.target = LocationId(target - 1);
    location.arcs.push_back(std::move(arc));
  }
  location.label = node.at("label").text();
  location.origin = origin_from_json(node.at("origin"));
  return location;
}

}  // namespace

Json to_json(const Program& program, std::span<const Plant> plants) {
  Json locations = Json::array();
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    locations.push_back(location_to_json(program.locations[l], l + 1, program));
  }
  Json json = object_with_room(4);
  json["name"] = program.name;
  const auto bound = std::find_if(plants.begin(), plants.end(),
                                  [&](const Plant& plant) { return plant.variables == program.variables; });
  if (bound != plants.end()) {
    json["plant"] = bound - plants.begin();
  } else {
    json["variables"] = to_json(program.variables);
  }
  json["clocks"] = program.clocks;
  json["locations"] = std::move(locations);
  return json;
}

Program program_from_json(const Node& node, std::span<const Plant> plants) {
  node.only({"name", "plant", "variables", "clocks", "locations"});
  Program program;
  program.name = node.at("name").text();
  if (node.has("plant") && node.has("variables")) node.at("variables").fail("a plant or variables, not both");
  if (node.has("plant")) {
    program.variables = plants[node.at("plant").index(plants.size())].variables;
  } else {
    program.variables = variables_from_json(node.at("variables"));
  }
  std::unordered_set<std::string> clocks;
  for (const Node& item : node.at("clocks").items()) {
    if (!clocks.insert(item.text()).second) item.fail("a clock that is new");
    program.clocks.push_back(item.text());
  }
  const auto locations = node.at("locations").items();
  if (locations.empty()) node.at("locations").fail("at least one location");
  std::set<ClockId> owned;
  for (std::size_t l = 0; l < locations.size(); ++l) {
    program.locations.push_back(location_from_json(locations[l], l, locations.size(), program, owned));
  }
  return program;
}

}  // namespace rmpl::automata
