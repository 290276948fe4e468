// Reads plants from JSON.
// SPDX-License-Identifier: MIT
#include "automata/json/plant_reader.hpp"

#include <algorithm>
#include <utility>

#include "automata/instance.hpp"
#include "automata/json/component_json.hpp"
#include "automata/json/document.hpp"

namespace rmpl::automata {
namespace {

/// How large what a document makes of its types may become, as `weight` counts: types within types multiply.
constexpr std::size_t weight_limit = std::size_t{1} << 28;
/// Types within types, and so the dots in a name.
constexpr std::size_t instance_depth_limit = 1000;

/// What a copy of what is written here costs, in bytes, roughly and at most a few times as much.
std::size_t weight(const Json& json) {
  constexpr std::size_t each = 16;
  if (json.is_string()) return json.get_ref<const std::string&>().size() + each;
  std::size_t sum = each;
  for (const Json& item : json) sum += json.is_structured() ? weight(item) : 0;
  return sum;
}

std::vector<Node> list(const Node& node, const char* key) {
  return node.has(key) ? node.at(key).items() : std::vector<Node>();
}

}  // namespace

void PlantReader::read_type(const Node& node) {
  node.only({"name", "variables", "components", "instances", "interconnections", "controls", "observables"});
  Part part = read(node);
  if (!types_.emplace(node.at("name").text(), std::move(part)).second) node.at("name").fail("a name that is new");
}

Plant PlantReader::read_plant(const Node& node) {
  for (const Node& item : list(node, "types")) read_type(item);
  node.only({"name", "types", "variables", "components", "instances", "interconnections", "controls", "observables"});
  Plant plant = read(node).plant;
  plant.name = node.at("name").text();
  if (plant.components.empty()) node.fail("at least one component");
  return plant;
}

PlantReader::Part PlantReader::read(const Node& node) {
  Part part;
  modes_.clear();
  taken_.clear();
  for (const Node& item : list(node, "variables")) add_variable(part, item);
  for (const Node& item : list(node, "components")) add_component(part, item);
  for (const Node& item : list(node, "instances")) add_instance(part, item);
  for (const Node& item : list(node, "interconnections")) add_interconnection(part, item);
  for (const Node& item : list(node, "controls")) add_control(part, item);
  for (const Node& item : list(node, "observables")) {
    grow(part, weight(item.json()), item);
    part.plant.observables.push_back(attribute(part.plant, item));
  }
  return part;
}

void PlantReader::grow(Part& part, std::size_t more, const Node& blame) {
  part.weight += more;
  made_ += more;
  if (made_ > weight_limit) blame.fail("a plant that is shorter when every instance is written out");
}

void PlantReader::add_variable(Part& part, const Node& node) {
  Variable variable = variable_from_json(node);
  if (variable.values.empty()) node.at("values").fail("at least one value");
  if (part.plant.variables.find(variable.name)) node.at("name").fail("a name that is new");
  grow(part, weight(node.json()), node);
  taken_.insert(variable.name.substr(0, variable.name.find('.')));
  part.plant.variables.add(std::move(variable));
}

void PlantReader::add_component(Part& part, const Node& node) {
  Component component = component_from_json(node, part.plant.variables);
  if (!modes_.insert(component.mode).second) node.at("name").fail("a name that is new");
  grow(part, weight(node.json()), node);
  part.plant.components.push_back(std::move(component));
}

void PlantReader::add_instance(Part& part, const Node& node) {
  node.only({"name", "type", "initial", "progress"});
  const auto type = types_.find(node.at("type").text());
  if (type == types_.end()) node.at("type").fail("the name of a type before, not '" + node.at("type").text() + "'");
  const Part& made = type->second;
  const std::string& name = node.at("name").text();
  if (name.empty() || name.find('.') != std::string::npos) node.at("name").fail("a name without dots");
  if (!taken_.insert(name).second) node.at("name").fail("a name that is new");
  grow(part, made.weight + made.plant.variables.size() * name.size(), node);
  part.depth = std::max(part.depth, made.depth + 1);
  if (part.depth > instance_depth_limit)
    node.fail("instances at most " + std::to_string(instance_depth_limit) + " deep");
  const std::size_t before = part.plant.components.size();
  instantiate(part.plant, name, made.plant);
  for (std::size_t c = before; c < part.plant.components.size(); ++c) modes_.insert(part.plant.components[c].mode);
  if (node.has("progress") && node.at("progress").truth()) {
    for (std::size_t c = before; c < part.plant.components.size(); ++c) part.plant.components[c].progress = true;
  }
  if (!node.has("initial")) return;
  if (made.plant.components.size() != 1) node.at("initial").fail("a type with one component");
  Component& component = part.plant.components.back();
  component.initial = initial_from_json(node.at("initial"), component);
}

void PlantReader::add_interconnection(Part& part, const Node& node) {
  node.only({"constraint", "origin"});
  Formula constraint = formula_from_json(node.at("constraint"), part.plant.variables);
  if (!is_of_states(constraint)) node.at("constraint").fail("an interconnection without clocks or knowledge");
  grow(part, weight(node.json()), node);
  part.plant.interconnections.emplace_back(std::move(constraint), origin_from_json(node.at("origin")));
}

void PlantReader::add_control(Part& part, const Node& node) {
  node.only({"variable", "idle"});
  Plant& plant = part.plant;
  const VariableId variable = attribute(plant, node.at("variable"));
  const auto idle = plant.variables[variable].find(node.at("idle").text());
  if (!idle) node.at("idle").fail("a value of '" + plant.variables.name(variable) + "'");
  grow(part, weight(node.json()), node);
  plant.controls.push_back({variable, *idle});
}

VariableId PlantReader::attribute(const Plant& plant, const Node& node) const {
  const auto id = plant.variables.find(node.text());
  if (!id || modes_.contains(*id)) node.fail("the name of an attribute, not '" + node.text() + "'");
  return *id;
}

}  // namespace rmpl::automata
