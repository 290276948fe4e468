// Compiled documents as JSON, and back.
// SPDX-License-Identifier: MIT
#include "automata/json/document.hpp"

#include "automata/json/model_json.hpp"

namespace rmpl::automata {
namespace {
constexpr const char* format_name = "rmpl-automata";
constexpr int format_version = 1;
}  // namespace

Json to_json(const Document& document) {
  Json plants = Json::array();
  for (const Plant& plant : document.plants) plants.push_back(to_json(plant));
  Json programs = Json::array();
  for (const Program& program : document.programs) programs.push_back(to_json(program));
  Json scenarios = Json::array();
  for (const Scenario& scenario : document.scenarios) scenarios.push_back(to_json(scenario, document));
  Json json{{"format", format_name},
            {"version", format_version},
            {"plants", std::move(plants)},
            {"programs", std::move(programs)}};
  if (!document.models.empty()) {
    json["models"] = Json::array();
    for (const ModelProgram& model : document.models) json["models"].push_back(to_json(model));
  }
  json["scenarios"] = std::move(scenarios);
  return json;
}

std::string to_text(const Document& document) { return to_json(document).dump(2) + "\n"; }

Document document_from_json(const Json& json) {
  const Node root(json);
  root.only({"format", "version", "plants", "programs", "models", "scenarios"});
  if (root.at("format").text() != format_name) root.at("format").fail(std::string("\"") + format_name + "\"");
  if (root.at("version").natural() != format_version) root.at("version").fail(std::to_string(format_version));
  Document document;
  for (const Node& item : root.at("plants").items()) document.plants.push_back(plant_from_json(item));
  for (const Node& item : root.at("programs").items()) document.programs.push_back(program_from_json(item));
  if (root.has("models")) {
    for (const Node& item : root.at("models").items()) document.models.push_back(model_program_from_json(item));
  }
  for (const Node& item : root.at("scenarios").items()) {
    document.scenarios.push_back(scenario_from_json(item, document));
  }
  for (std::size_t s = 0; s < document.scenarios.size(); ++s) {
    const Scenario& scenario = document.scenarios[s];
    if (!(document.programs[scenario.program].variables == document.plants[scenario.plant].variables)) {
      root.at("scenarios").items()[s].fail("a program that is bound to the scenario's plant");
    }
  }
  return document;
}

Document read_document(std::string_view text, const std::string& name) {
  try {
    return document_from_json(parse_json(text));
  } catch (const Json::exception& error) {
    throw base::InputError(name + ": " + error.what());
  } catch (const base::InputError& error) {
    throw base::InputError(name + ": " + error.what());
  }
}

}  // namespace rmpl::automata
