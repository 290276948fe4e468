// Plants as JSON, and back: types stand once, instances by reference.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "automata/instance.hpp"
#include "automata/json/component_json.hpp"
#include "automata/json/document.hpp"
#include "automata/outline.hpp"

namespace rmpl::automata {
namespace {

/// How large what a document makes of its types may become, as `weight` counts: types within types multiply.
constexpr std::size_t weight_limit = std::size_t{1} << 28;
/// Types within types, and so the dots in a name.
constexpr std::size_t depth_limit = 1000;

/// Adds a plant or a type: its own things in full, what it has instances of by reference.
void add_parts(Json& json, const Plant& plant, const PlantParts& parts, const std::vector<PlantType>& types) {
  Json variables = Json::array();
  for (std::size_t v = 0; v < parts.variables; ++v) variables.push_back(to_json(plant.variables[VariableId(v)]));
  Json components = Json::array();
  for (std::size_t c = 0; c < parts.components; ++c) {
    components.push_back(component_to_json(plant.components[c], plant.variables));
  }
  Json instances = Json::array();
  for (const PlantInstance& instance : parts.instances) {
    Json& item = instances.emplace_back(Json{{"name", instance.name}, {"type", types[instance.type].name}});
    if (instance.initial) item["initial"] = *instance.initial;
  }
  Json interconnections = Json::array();
  for (std::size_t q = parts.interconnections; q < plant.interconnections.size(); ++q) {
    const Interconnection& interconnection = plant.interconnections[q];
    interconnections.push_back({{"constraint", to_json(interconnection.constraint, plant.variables)},
                                {"origin", to_json(interconnection.origin)}});
  }
  Json controls = Json::array();
  for (std::size_t c = parts.controls; c < plant.controls.size(); ++c) {
    const Control& control = plant.controls[c];
    controls.push_back({{"variable", plant.variables.name(control.variable)},
                        {"idle", plant.variables.value({control.variable, control.idle})}});
  }
  Json observables = Json::array();
  for (std::size_t o = parts.observables; o < plant.observables.size(); ++o) {
    observables.push_back(plant.variables.name(plant.observables[o]));
  }
  const auto add = [&](const char* key, Json list) {
    if (!list.empty()) json[key] = std::move(list);
  };
  add("variables", std::move(variables));
  add("components", std::move(components));
  add("instances", std::move(instances));
  add("interconnections", std::move(interconnections));
  add("controls", std::move(controls));
  add("observables", std::move(observables));
}

/// What a copy of what is written here costs, in bytes, roughly and at most a few times as much.
std::size_t weight(const Json& json) {
  constexpr std::size_t each = 16;
  if (json.is_string()) return json.get_ref<const std::string&>().size() + each;
  std::size_t sum = each;
  for (const Json& item : json) sum += json.is_structured() ? weight(item) : 0;
  return sum;
}

/// A plant or a type, with names relative to itself.
struct Part {
  Plant plant;
  std::size_t weight = 0;  ///< with all instances
  std::size_t depth = 0;   ///< of instances within instances
};

class PlantReader {
 public:
  Plant run(const Node& node) {
    if (node.has("types")) {
      for (const Node& item : node.at("types").items()) {
        item.only({"name", "variables", "components", "instances", "interconnections", "controls", "observables"});
        Part part = read(item);
        if (!types_.emplace(item.at("name").text(), std::move(part)).second) item.at("name").fail("a name that is new");
      }
    }
    node.only({"name", "types", "variables", "components", "instances", "interconnections", "controls", "observables"});
    Plant plant = read(node).plant;
    plant.name = node.at("name").text();
    if (plant.components.empty()) node.fail("at least one component");
    return plant;
  }

 private:
  Part read(const Node& node) {
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

  static std::vector<Node> list(const Node& node, const char* key) {
    return node.has(key) ? node.at(key).items() : std::vector<Node>();
  }

  void grow(Part& part, std::size_t more, const Node& blame) {
    part.weight += more;
    made_ += more;
    if (made_ > weight_limit) blame.fail("a plant that is shorter when every instance is written out");
  }

  void add_variable(Part& part, const Node& node) {
    Variable variable = variable_from_json(node);
    if (variable.values.empty()) node.at("values").fail("at least one value");
    if (part.plant.variables.find(variable.name)) node.at("name").fail("a name that is new");
    grow(part, weight(node.json()), node);
    taken_.insert(variable.name.substr(0, variable.name.find('.')));
    part.plant.variables.add(std::move(variable));
  }

  void add_component(Part& part, const Node& node) {
    Component component = component_from_json(node, part.plant.variables);
    if (!modes_.insert(component.mode).second) node.at("name").fail("a name that is new");
    grow(part, weight(node.json()), node);
    part.plant.components.push_back(std::move(component));
  }

  void add_instance(Part& part, const Node& node) {
    node.only({"name", "type", "initial"});
    const auto type = types_.find(node.at("type").text());
    if (type == types_.end()) node.at("type").fail("the name of a type before, not '" + node.at("type").text() + "'");
    const Part& made = type->second;
    const std::string& name = node.at("name").text();
    if (name.empty() || name.find('.') != std::string::npos) node.at("name").fail("a name without dots");
    if (!taken_.insert(name).second) node.at("name").fail("a name that is new");
    grow(part, made.weight + made.plant.variables.size() * name.size(), node);
    part.depth = std::max(part.depth, made.depth + 1);
    if (part.depth > depth_limit) node.fail("instances at most " + std::to_string(depth_limit) + " deep");
    const std::size_t before = part.plant.components.size();
    instantiate(part.plant, name, made.plant);
    for (std::size_t c = before; c < part.plant.components.size(); ++c) modes_.insert(part.plant.components[c].mode);
    if (!node.has("initial")) return;
    if (made.plant.components.size() != 1) node.at("initial").fail("a type with one component");
    Component& component = part.plant.components.back();
    component.initial = initial_from_json(node.at("initial"), component);
  }

  void add_interconnection(Part& part, const Node& node) {
    node.only({"constraint", "origin"});
    Formula constraint = formula_from_json(node.at("constraint"), part.plant.variables);
    if (has_clock(constraint)) node.at("constraint").fail("an interconnection without clocks");
    grow(part, weight(node.json()), node);
    part.plant.interconnections.emplace_back(std::move(constraint), origin_from_json(node.at("origin")));
  }

  void add_control(Part& part, const Node& node) {
    node.only({"variable", "idle"});
    Plant& plant = part.plant;
    const VariableId variable = attribute(plant, node.at("variable"));
    const auto idle = plant.variables[variable].find(node.at("idle").text());
    if (!idle) node.at("idle").fail("a value of '" + plant.variables.name(variable) + "'");
    grow(part, weight(node.json()), node);
    plant.controls.push_back({variable, *idle});
  }

  [[nodiscard]] VariableId attribute(const Plant& plant, const Node& node) const {
    const auto id = plant.variables.find(node.text());
    if (!id || modes_.contains(*id)) node.fail("the name of an attribute, not '" + node.text() + "'");
    return *id;
  }

  std::unordered_map<std::string, Part> types_;
  std::unordered_set<VariableId> modes_;   ///< of what is being read
  std::unordered_set<std::string> taken_;  ///< what names in it begin with, up to a dot
  std::size_t made_ = 0;
};

}  // namespace

Json to_json(const Plant& plant) {
  const PlantOutline outline = outline_of(plant);
  Json json = object_with_room(8);
  json["name"] = plant.name;
  if (!outline.types.empty()) json["types"] = Json::array();
  for (const PlantType& type : outline.types) {
    Json& item = json["types"].emplace_back(object_with_room(7));
    item["name"] = type.name;
    add_parts(item, type.plant, type.parts, outline.types);
  }
  add_parts(json, plant, outline.whole, outline.types);
  return json;
}

Plant plant_from_json(const Node& node) { return PlantReader().run(node); }

}  // namespace rmpl::automata
