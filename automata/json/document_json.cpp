// Compiled documents as JSON, and back.
// SPDX-License-Identifier: MIT
#include "automata/json/document.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "automata/json/layout.hpp"
#include "automata/json/model_json.hpp"
#include "automata/json/plant_reader.hpp"

namespace rmpl::automata {
namespace {
constexpr const char* format_name = "rmpl-automata";
constexpr int format_version = 2;
/// Each program has the variables of its plant: so many in all, above what any input set has.
constexpr std::size_t variables_limit = std::size_t{1} << 23;
}  // namespace

Json to_json(const Document& document) {
  Json plants = Json::array();
  for (const Plant& plant : document.plants) plants.push_back(to_json(plant));
  Json programs = Json::array();
  for (const Program& program : document.programs) programs.push_back(to_json(program, document.plants));
  Json scenarios = Json::array();
  for (const Scenario& scenario : document.scenarios) scenarios.push_back(to_json(scenario, document));
  Json json = object_with_room(6);
  json["format"] = format_name;
  json["version"] = format_version;
  json["plants"] = std::move(plants);
  json["programs"] = std::move(programs);
  if (!document.models.empty()) {
    json["models"] = Json::array();
    for (const ModelProgram& model : document.models) json["models"].push_back(to_json(model));
  }
  json["scenarios"] = std::move(scenarios);
  return json;
}

std::string to_text(const Document& document) { return laid_out(to_json(document)) + "\n"; }

namespace {

/// `readers`, one a plant, have read types that are not in the JSON any more.
Document document_of(const Json& json, std::vector<PlantReader> readers) {
  const Node root(json);
  root.only({"format", "version", "plants", "programs", "models", "scenarios"});
  if (root.at("format").text() != format_name) root.at("format").fail(std::string("\"") + format_name + "\"");
  if (root.at("version").natural() != format_version) root.at("version").fail(std::to_string(format_version));
  Document document;
  const std::vector<Node> plants = root.at("plants").items();
  readers.resize(std::max(readers.size(), plants.size()));
  for (std::size_t p = 0; p < plants.size(); ++p) document.plants.push_back(readers[p].read_plant(plants[p]));
  std::size_t copied = 0;
  for (const Node& item : root.at("programs").items()) {
    const Program& program = document.programs.emplace_back(program_from_json(item, document.plants));
    if (item.has("plant")) copied += program.variables.size();
    if (copied > variables_limit) item.fail("fewer programs of a plant of so many variables");
  }
  if (root.has("models")) {
    for (const Node& item : root.at("models").items()) document.models.push_back(model_program_from_json(item));
  }
  for (const Node& item : root.at("scenarios").items()) {
    document.scenarios.push_back(scenario_from_json(item, document));
  }
  for (std::size_t s = 0; s < document.scenarios.size(); ++s) {
    const Scenario& scenario = document.scenarios[s];
    if (!(document.programs[scenario.program].variables == document.plant_of(scenario).variables)) {
      root.at("scenarios").items()[s].fail("a program that is bound to the scenario's plant");
    }
  }
  return document;
}

/// Where a value is the next of an array under the key, in an object.
bool is_item(const JsonLevels& levels, std::size_t object, const std::string& key) {
  return levels[object]->is_object() && levels[object]->get_ref<const Json::object_t&>().back().first == key &&
         levels[object + 1]->is_array();
}

}  // namespace

Document document_from_json(const Json& json) { return document_of(json, {}); }

std::optional<Document> read_plain_document(std::string_view text) {
  std::vector<PlantReader> readers;
  const auto take_type = [&readers](const JsonLevels& levels) {
    if (!is_item(levels, 0, "plants") || !is_item(levels, 2, "types")) return;
    const std::size_t plant = levels[1]->size() - 1;
    if (plant >= readers.size()) readers.resize(plant + 1);
    readers[plant].read_type(Node(*levels[4]));
    levels[3]->get_ref<Json::array_t&>().pop_back();
  };
  try {
    const auto json = scan_json_value(text, 5, take_type);
    return json ? std::optional(document_of(*json, std::move(readers))) : std::nullopt;
  } catch (const base::InputError&) {
    return std::nullopt;
  }
}

Document read_document(std::string_view text, const std::string& name) {
  if (auto plain = read_plain_document(text)) return std::move(*plain);
  try {
    return document_from_json(parse_json(text));
  } catch (const Json::exception& error) {
    throw base::InputError(name + ": " + error.what());
  } catch (const base::InputError& error) {
    throw base::InputError(name + ": " + error.what());
  }
}

}  // namespace rmpl::automata
