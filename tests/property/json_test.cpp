// Automata to JSON and back: nothing is lost, and the bytes are the same.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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
    scenario.expectations.push_back({automata::Expectation::Kind::never, true, condition, {}, {}, "", {}});
  if (chance(50))
    scenario.expectations.push_back(
        {automata::Expectation::Kind::eventually, false, condition, condition, Ticks::of_seconds(60), "text", {}});
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
                                    .programs = {(*programs(model.plant)).program},
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
