// Compiled documents: round trip, and what is refused with its path.
// SPDX-License-Identifier: MIT
#include "automata/json/document.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rmpl::automata {
namespace {

/// x is a until a choice between staying and b, and a drawn start; told to be either where nothing else is said.
ModelProgram sample_model() {
  ModelProgram model;
  model.name = "Story";
  const auto x = model.variables.add({"x", {"a", "b"}});
  const auto cmd = model.variables.add({"cmd", {"none", "go"}});
  model.controls = {{cmd, ValueId(0)}};
  model.observables = {x};
  model.constraints.emplace_back(implication(is(cmd, ValueId(1)), is(x, ValueId(1))), Origin{"m.rmpl", 2, 1});
  ModelLocation whole;
  whole.composite = true;
  whole.maintenance = {false, is(x, ValueId(1))};
  ModelLocation told;
  told.parent = LocationId(0);
  told.told = is(x, ValueId(0));
  told.functions = {{1, {}, {{{{true, is(cmd, ValueId(1))}}, LocationId(2)}}}};
  ModelLocation choice = told;
  choice.start = true;
  choice.told = constant(true);
  choice.functions = {{0.25, {LocationId(1)}, {}}, {0.75, {}, {{{}, LocationId(2)}}}};
  ModelLocation first = choice;
  first.start = false;
  first.functions = {{1, {}, {}}};
  model.locations = {whole, told, choice, first};
  model.initial = {{LocationId(3), {{0.5, {LocationId(1)}}, {0.5, {LocationId(1), LocationId(2)}}}}};
  model.origin = {"m.rmpl", 1, 1};
  return model;
}

Plant sample_software() {
  Plant plant;
  plant.name = "Software";
  const auto mode = plant.variables.add({"task", {"Idle", "Odd", "Idle_improbable"}});
  Component task{"task", "Task", mode, {}, {1, 0, 0}, {}, {"m.rmpl", 3, 1}, true, true};
  task.modes = {{"Idle", false, constant(true), 0, {}},
                {"Odd", true, constant(true), 0, {}},
                {"Idle_improbable", true, constant(true), 0, {}, ModeId(0)}};
  task.transitions = {{ModeId(0), ModeId(2), constant(true), {}, {Weight::Kind::probability, 0.01}, 0, {}},
                      {ModeId(1), ModeId(1), constant(true), {}, {Weight::Kind::probability, 0.9}, 1, {}, false, true}};
  plant.components.push_back(task);
  return plant;
}

Document sample() {
  Plant plant;
  plant.name = "Sample";
  const auto mode = plant.variables.add({"pump", {"off", "on", "broken"}});
  const auto cmd = plant.variables.add({"pump.cmd", {"none", "start"}});
  const auto flow = plant.variables.add({"pump.flow", {"no", "yes"}});
  Component pump{"pump", "Pump", mode, {}, {0.5, 0.5, 0}, {}, {"a.tcca", 3, 1}};
  pump.modes = {{"off", false, is(flow, ValueId(0)), 0, {"a.tcca", 4, 3}},
                {"on", false, negation(is(flow, ValueId(0))), -1.5, {"a.tcca", 5, 3}},
                {"broken", true, constant(true), -20, {"a.tcca", 6, 3}}};
  const Timing timing{Ticks::of_seconds(1), Ticks::infinite(), {Density::Kind::normal, 4, 2}};
  pump.transitions = {{ModeId(0), ModeId(1), is(cmd, ValueId(1)), timing, {}, 1, {"a.tcca", 7, 3}},
                      {ModeId(1), ModeId(2), constant(true), {}, {Weight::Kind::rate, 1e-6}, 2, {"a.tcca", 8, 3}}};
  plant.components.push_back(pump);
  plant.interconnections.emplace_back(
      implication(is(flow, ValueId(1)), disjunction({is(cmd, ValueId(0)), is(cmd, ValueId(1))})),
      automata::Origin{"a.tcca", 12, 3});
  plant.controls.push_back({cmd, ValueId(0)});
  plant.observables.push_back(flow);

  Program program;
  program.name = "Main";
  program.variables = plant.variables;
  program.clocks = {"t"};
  program.locations.emplace_back().composite = true;
  Location start;
  start.parent = LocationId(0);
  start.start = true;
  start.goal = {{mode, ValueId(1)}};
  start.clock_start = ClockId(0);
  start.label = "pump = on";
  start.arcs.push_back({{false, clock_bound(ClockId(0), Comparison::less, Ticks::of_seconds(9))}, LocationId(1)});
  program.locations.push_back(start);

  Scenario scenario;
  scenario.name = "story";
  scenario.truth = {{mode, ValueId(0)}};
  scenario.forced.push_back({Ticks::of_seconds(5), ComponentId(0), ModeId(2), {"a.scn", 2, 1}});
  scenario.forced.push_back(
      {Ticks::of_seconds(6), ComponentId(0), ModeId(2), {"a.scn", 3, 1}, Assignment{flow, ValueId(1)}, {ModeId(1)}});
  scenario.commands.push_back({Ticks{1}, Ticks{2}, {cmd, ValueId(1)}, {}});
  scenario.overrides.push_back({Ticks{1}, Ticks::infinite(), {flow, ValueId(1)}, {}});
  scenario.samples.push_back({Ticks{1}, "FLOW", 2.5, "2.50", {}});
  scenario.samples.push_back({Ticks{2}, "FLOW", std::nullopt, "n/a", {}});
  scenario.rules.push_back({Rule::Stream::command, is(cmd, ValueId(1)), 86, {}, {flow, ValueId(1)}, Ticks{5}, {}});
  scenario.expectations.push_back({Expectation::Kind::eventually,
                                   true,
                                   is(mode, ValueId(1)),
                                   is(mode, ValueId(0)),
                                   Ticks::of_seconds(60),
                                   "expect truth …",
                                   {"FDIR-12"},
                                   {}});
  Document document{{plant, sample_software()}, {program}, {}, {scenario}};
  document.models.push_back(sample_model());
  return document;
}

TEST(Document, RoundTripKeepsEverythingAndEveryByte) {
  const Document document = sample();
  const std::string text = to_text(document);
  const Document again = read_document(text, "x.json");
  EXPECT_EQ(again, document);
  EXPECT_EQ(to_text(again), text);
}

TEST(Document, WhatIsWrongIsNamedWithItsPath) {
  const Json good = to_json(sample());
  const auto refuses = [&](const std::string& pointer, const Json& value, const std::string& why) {
    Json bad = good;
    bad[Json::json_pointer(pointer)] = value;
    try {
      document_from_json(bad);
      ADD_FAILURE() << "accepted " << value << " at " << pointer;
    } catch (const base::InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(why)) << pointer;
    }
  };
  refuses("/version", 1, "/version: expected 2");
  refuses("/plants/0/types/0/components/0/initial/0", 1.5,
          "/plants/0/types/0/components/0/initial/0: expected a probability");
  refuses("/plants/0/types/0/components/0/initial/0", 0.1, "sum to 1");
  refuses("/plants/0/types/0/components/0/transitions/0/to", "onn", "not 'onn'");
  refuses("/plants/0/types/0/components/0/transitions/0/timing/lower", "inf", "lower finite");
  refuses("/plants/0/types/0/components/0/transitions/0/timing/lower", -5, "whole n");
  refuses("/plants/0/types/0/variables/1/name", "", "a name that is new");
  refuses("/plants/0/interconnections/0/constraint", Json::object(),
          "/plants/0/interconnections/0/constraint: expected a formula");
  refuses("/plants/0/controls/0/variable", "pump", "attribute");
  refuses("/plants/0/instances/0/type", "Pomp", "expected the name of a type before, not 'Pomp'");
  refuses("/plants/0/instances/0/name", "", "/plants/0/instances/0/name: expected a name without dots");
  refuses("/plants/0/instances/0/name", "a.b", "expected a name without dots");
  refuses("/plants/0/instances/1", {{"name", "pump"}, {"type", "Pump"}}, "expected a name that is new");
  refuses("/plants/0/instances/0/initial", {1, 0}, "expected a probability for each mode");
  refuses("/plants/1/types/0/components/0/modes/2/usual", "Busy", "not 'Busy'");
  refuses("/plants/0/types/1", good["plants"][0]["types"][0], "/plants/0/types/1/name: expected a name that is new");
  refuses("/programs/0/plant", 2, "/programs/0/plant: expected a whole number below 2");
  refuses("/programs/0/variables", Json::array(), "expected a plant or variables, not both");
  refuses("/plants/0/name", "P\x1b[31m", "without control characters");
  refuses("/programs/0/locations/1/arcs/0/target", 3, "below 3");
  refuses("/programs/0/locations/1/parent", 0, "a composite that comes before");
  refuses("/scenarios/0/plant", 2, "below 2");
  refuses("/scenarios/0/cycle", 0, "above 0");
  refuses("/scenarios/0/samples/0/value", true, "expected a number or a string");
  refuses("/scenarios/0/samples/0/text", 2.5, "expected a string");
  refuses("/scenarios/0/overrides/0/reading", {"pump", "on"}, "expected an observable and its value");
  refuses("/scenarios/0/rules/0/reading", {"pump.cmd", "start"}, "expected an observable and its value");
  refuses("/scenarios/0/rules/0/trigger", {{"variable", "pump.flow"}, {"in", {"yes"}}}, "expected values of controls");
  refuses("/scenarios/0/rules/0/stream", "estimate", "expected modes of components");
  refuses("/models/0/controls/0/idle", "stop", "a value of 'cmd'");
  refuses("/models/0/observables/0", "z", "not 'z'");
  refuses("/models/0/locations/0/kind", "primitive", "the program itself");
  refuses("/models/0/locations/2/functions/0/probability", 0.3,
          "/models/0/locations/2/functions: expected probabilities that sum to 1");
  refuses("/models/0/locations/2/functions/0/started/0", 1,
          "/models/0/locations/2/functions/0/started/0: expected the number of a primitive location with one function");
  refuses("/models/0/locations/2/functions/0/started/0", 5, "below 5");
  refuses("/models/0/locations/2/functions/1/arcs/0/target", 0, "the number of a location, from 1");
  refuses("/models/0/initial/0/choice", 3, "a primitive location that is no start");
  refuses("/models/0/initial/0/branches/1/started", {3, 2}, "in order");
  refuses("/programs/0/clocks", {"t", "t"}, "/programs/0/clocks/1: expected a clock that is new");
}

TEST(Document, KeysThatItDoesNotHaveAreRefusedAnywhere) {
  const Json good = to_json(sample());
  std::size_t objects = 0;
  const auto refuse_within = [&](const Json& part, const std::string& path, const auto& self) -> void {
    if (part.is_object()) {
      ++objects;
      Json bad = good;
      bad[Json::json_pointer(path)]["rewrad"] = 1;
      try {
        document_from_json(bad);
        ADD_FAILURE() << "accepted at " << path;
      } catch (const JsonError& error) {
        EXPECT_EQ(error.path(), path + "/rewrad");
        EXPECT_EQ(error.blame(), JsonError::Blame::key);
        EXPECT_THAT(error.what(), testing::HasSubstr("unknown key 'rewrad'"));
      }
      for (const auto& [key, value] : part.items()) self(value, member_path(path, key), self);
    } else if (part.is_array()) {
      for (std::size_t i = 0; i < part.size(); ++i) self(part[i], path + "/" + std::to_string(i), self);
    }
  };
  refuse_within(good, "", refuse_within);
  EXPECT_GT(objects, 40U);
}

TEST(Document, TwoWeightsOfOneTransitionAreRefused) {
  Json bad = to_json(sample());
  bad["plants"][0]["types"][0]["components"][0]["transitions"][1]["probability"] = 0.5;
  EXPECT_THROW(document_from_json(bad), JsonError);
}

TEST(Document, TextThatIsNoJsonIsRefusedWithTheFileName) {
  for (const std::string text : {"", "{", "[]", "nul", "{\"format\": \"x\"}"}) {
    try {
      read_document(text, "x.json");
      ADD_FAILURE() << "accepted " << text;
    } catch (const base::InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("x.json: "));
    }
  }
}

TEST(Document, DeepFormulasAreRefusedNotCrashedOn) {
  Json deep = true;
  for (int i = 0; i < 10000; ++i) deep = Json{{"not", std::move(deep)}};
  Json bad = to_json(sample());
  bad["plants"][0]["interconnections"][0]["constraint"] = std::move(deep);
  EXPECT_THROW(document_from_json(bad), base::InputError);
}

}  // namespace
}  // namespace rmpl::automata
