// Plants as JSON: types stand once, instances by reference.
// SPDX-License-Identifier: MIT
#include <utility>

#include "automata/json/component_json.hpp"
#include "automata/json/document.hpp"
#include "automata/outline.hpp"

namespace rmpl::automata {
namespace {

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
    if (instance.progress) item["progress"] = true;
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

}  // namespace rmpl::automata
