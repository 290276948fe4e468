// Automata to JSON and back: nothing is lost, and the bytes are the same.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "automata/instance.hpp"
#include "automata/json/document.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"

namespace rmpl::property {
namespace {

using automata::Ticks;

automata::Scenario draw_scenario(const automata::Plant& plant) {
  automata::Scenario scenario;
  scenario.name = "a \"quoted\" name";
  scenario.rules_only = chance(50);
  scenario.cycle = Ticks{static_cast<std::int64_t>(up_to(1, 4)) * Ticks::per_second / 4};
  scenario.duration = Ticks::of_seconds(static_cast<std::int64_t>(up_to(1, 1000)));
  scenario.seed = up_to(0, 1000);
  const automata::Component& component = pick(plant.components);
  const automata::ModeId mode(up_to(0, component.modes.size() - 1));
  const automata::Assignment in_mode{component.mode, automata::ValueId(mode.index())};
  if (chance(50)) scenario.truth.push_back(in_mode);
  if (chance(50))
    scenario.forced.push_back({Ticks{1}, *plant.find_component(component.name), mode, {"random.scn", 3, 4}});
  const auto condition = *formulas(plant.variables, {component.mode});
  if (chance(50))
    scenario.expectations.push_back({automata::Expectation::Kind::never, true, condition, {}, {}, "", {}, {}});
  if (chance(50))
    scenario.expectations.push_back({automata::Expectation::Kind::eventually,
                                     false,
                                     condition,
                                     condition,
                                     Ticks::of_seconds(60),
                                     "text",
                                     {"R 1", "R-2"},
                                     {}});
  if (!plant.controls.empty() && chance(50)) {
    const automata::Assignment command{pick(plant.controls).variable, automata::ValueId(std::size_t{0})};
    scenario.commands.push_back({Ticks{3}, Ticks{8}, command, {"random.scn", 5, 6}});
  }
  if (chance(50)) scenario.samples.push_back({Ticks{4}, "P \"1\"", 0.1, "1e-1", {}});
  if (chance(50)) scenario.samples.push_back({Ticks{5}, "P 2", std::nullopt, "n/a", {}});
  if (plant.observables.empty()) return scenario;
  const automata::Assignment reading{pick(plant.observables), automata::ValueId(std::size_t{1})};
  if (chance(50)) scenario.overrides.push_back({Ticks{5}, Ticks::infinite(), reading, {}});
  if (chance(50))
    scenario.rules.push_back({automata::Rule::Stream::estimate, condition, 86, std::nullopt, reading, Ticks{7}, {}});
  if (chance(50))
    scenario.rules.push_back(
        {automata::Rule::Stream::estimate, condition, 0, Ticks{9}, reading, Ticks::infinite(), {}});
  return scenario;
}

RC_GTEST_PROP(Json, DocumentsComeBackTheSame, ()) {
  const Model model = *models({.rewards = true});
  const automata::Document document{.plants = {model.plant},
                                    .programs = {(*programs_that_know(model.plant)).program},
                                    .models = {},
                                    .scenarios = {draw_scenario(model.plant)}};
  const automata::Json json = automata::to_json(document);
  const std::string text = json.dump(2);
  const automata::Document back = automata::read_document(text, "document.json");
  RC_ASSERT(back.plants == document.plants);
  RC_ASSERT(back.programs == document.programs);
  RC_ASSERT(back.scenarios == document.scenarios);
  RC_ASSERT(automata::to_json(back).dump(2) == text);
}

/// A component type over attributes of its own, as the compiler lowers it: its mode is named "".
automata::Plant draw_component_type(std::size_t number) {
  automata::Plant type;
  const auto mode = type.variables.add({"", {"a", "b"}});
  std::vector<automata::VariableId> attributes;
  for (std::size_t i = up_to(1, 3); i > 0; --i) {
    attributes.push_back(type.variables.add({"x" + std::to_string(i), {"p", "q"}}));
  }
  automata::Component component{"", "Type" + std::to_string(number), mode, {}, {1, 0}, {}, {"random.tcca", 1, 1}};
  for (const std::string& name : type.variables[mode].values) {
    component.modes.push_back({name, false, *formulas(type.variables, attributes), 0, {"random.tcca", 2, 3}});
  }
  component.transitions.push_back(
      {automata::ModeId(0), automata::ModeId(1), *formulas(type.variables, attributes), {}, {}, 0, {}});
  type.components.push_back(component);
  return type;
}

/// A module, or the plant, of instances of some of the types, with what it says itself.
automata::Plant draw_module(const std::vector<automata::Plant>& types) {
  automata::Plant module;
  if (chance(30)) module.variables.add({"port", {"p", "q"}});
  for (std::size_t i = up_to(1, 4); i > 0; --i) {
    const automata::Plant& type = pick(types);
    automata::instantiate(module, "i" + std::to_string(i), type);
    if (type.components.size() == 1 && chance(20)) module.components.back().initial = {0, 1};
  }
  std::vector<automata::VariableId> attributes;
  for (const automata::VariableId id : all_variables(module)) {
    if (!module.component_of(id)) attributes.push_back(id);
  }
  for (std::size_t i = up_to(0, 2); i > 0; --i) {
    module.interconnections.emplace_back(*formulas(module.variables, attributes));
  }
  if (chance(50)) module.controls.push_back({pick(attributes), automata::ValueId(0)});
  if (chance(50)) module.observables.push_back(pick(attributes));
  return module;
}

RC_GTEST_PROP(Json, ModulesStandOnceAndComeBackTheSame, ()) {
  std::vector<automata::Plant> types;
  for (std::size_t i = up_to(1, 2); i > 0; --i) types.push_back(draw_component_type(i));
  for (std::size_t i = up_to(0, 3); i > 0; --i) types.push_back(draw_module(types));
  automata::Plant plant = draw_module(types);
  plant.name = "Random";
  if (chance(10)) std::swap(plant.components.front(), plant.components.back());
  const automata::Document document{{plant}, {}, {}, {}};
  const automata::Json json = automata::to_json(document);
  const automata::Document back = automata::read_document(json.dump(), "document.json");
  RC_ASSERT(back == document);
  RC_ASSERT(automata::to_json(back) == json);
  // What is written out in full is what the types have: each is there at most once as it is, and once as a last
  // instance that what is said around it seems to belong to.
  if (json["plants"][0].contains("types")) RC_ASSERT(json["plants"][0]["types"].size() <= 4 * types.size());
}

RC_GTEST_PROP(Json, FormulasComeBackTheSame, ()) {
  Model model = *models();
  const auto formula = *formulas(model.plant.variables, all_variables(model.plant), 3);
  model.plant.interconnections = {formula};
  const automata::Document document{{model.plant}, {}, {}, {}};
  const automata::Document back = automata::read_document(automata::to_json(document).dump(), "document.json");
  RC_ASSERT(back.plants.front().interconnections.front().constraint == formula);
}

}  // namespace
}  // namespace rmpl::property
