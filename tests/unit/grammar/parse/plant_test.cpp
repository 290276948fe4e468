// Plant models: every declaration and every form of a transition.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/unit/grammar/parse/trees.hpp"

namespace rmpl::grammar {
namespace {

using test::Parsed;

Parsed<PlantFile> component_with(const std::string& items) {
  return Parsed<PlantFile>(parse_plant, "component C {" + items + "}");
}

template <class Item>
Item only(const Parsed<PlantFile>& result) {
  EXPECT_TRUE(result.tree) << result.errors();
  const auto& items = std::get<ComponentDefinition>(result.tree->items.at(0)).items;
  EXPECT_EQ(items.size(), 1u);
  return std::get<Item>(items.at(0));
}

TEST(PlantParse, TheEngineOfTheLanguagePage) {
  const Parsed<PlantFile> result(parse_plant, R"(import "valve.tcca";
    domain Level = { zero, low, nominal, high };
    component Engine {
      input    cmd   : { none, standby, fire, off };
      input    fuel, oxidizer : Level;
      output   thrust : { zero, full };
      output   temp   : Level;
      internal heat   : { no, yes };
      initial off;
      mode  off     { thrust = zero & temp = zero };
      mode  heating { thrust = zero & temp in {low, nominal} };
      mode  standby { thrust = zero & temp = nominal };
      mode  firing  { thrust = full } reward -5;
      fault failed  reward -20;
      fault lost    { thrust = zero } reward -20;
      off     -> heating when cmd = standby;
      heating -> off     when cmd = off;
      heating -> standby when cmd != off in [30 s, 60 s];
      standby -> firing  when cmd = fire & fuel = high & oxidizer = high;
      standby, firing -> off when cmd = off;
      any     -> failed  with 0.001;
      any nominal -> lost with rate 1e-6 /h;
    }
    module Propulsion {
      input  cmd    : { none, on };
      pde    : Pde;
      engine : Engine { initial standby; };
      pde.engine_cmd = engine.cmd;
    }
    plant Lander {
      prop : Propulsion;
      control prop.cmd default none;
      observe prop.engine.temp, prop.engine.thrust;
    })");
  ASSERT_TRUE(result.tree) << result.errors();
  ASSERT_EQ(result.tree->items.size(), 5u);
  EXPECT_EQ(std::get<ComponentDefinition>(result.tree->items[2]).items.size(), 19u);
  const auto& module = std::get<ModuleDefinition>(result.tree->items[3]);
  EXPECT_FALSE(module.plant);
  EXPECT_EQ(std::get<InstanceDeclaration>(module.items.at(2)).initial->modes.at(0).mode.text, "standby");
  EXPECT_EQ(test::tree(std::get<Interconnection>(module.items.at(3)).constraint), "pde.engine_cmd=engine.cmd");
  const auto& plant = std::get<ModuleDefinition>(result.tree->items[4]);
  EXPECT_TRUE(plant.plant);
  EXPECT_EQ(std::get<Control>(plant.items.at(1)).idle->text, "none");
  EXPECT_EQ(std::get<Observe>(plant.items.at(2)).names.size(), 2u);
}

TEST(PlantParse, InstancesOfModelPrograms) {
  const Parsed<PlantFile> result(parse_plant, "plant P { a, b : model Task; c : model; d : Valve; }");
  ASSERT_TRUE(result.tree) << result.errors();
  const auto& items = std::get<ModuleDefinition>(result.tree->items.at(0)).items;
  ASSERT_EQ(items.size(), 3u);
  const auto& tasks = std::get<InstanceDeclaration>(items[0]);
  EXPECT_TRUE(tasks.model);
  EXPECT_EQ(tasks.names.size(), 2u);
  EXPECT_EQ(tasks.type.text, "Task");
  EXPECT_FALSE(std::get<InstanceDeclaration>(items[1]).model) << "a type may be called `model`";
  EXPECT_EQ(std::get<InstanceDeclaration>(items[1]).type.text, "model");
  EXPECT_FALSE(std::get<InstanceDeclaration>(items[2]).model);
}

TEST(PlantParse, Modes) {
  const auto firing = only<ModeDeclaration>(component_with("mode firing { thrust = full } reward -5;"));
  EXPECT_EQ(firing.reward->value, -5);
  EXPECT_EQ(test::tree(*firing.constraint), "thrust=full");
  const auto failed = only<ModeDeclaration>(component_with("fault failed;"));
  EXPECT_TRUE(failed.fault);
  EXPECT_FALSE(failed.constraint || failed.reward);
}

TEST(PlantParse, InitialDistributions) {
  const auto initial = only<Initial>(component_with("initial off 0.9, on 0.1;"));
  ASSERT_EQ(initial.modes.size(), 2u);
  EXPECT_EQ(initial.modes[0].probability->value, 0.9);
  EXPECT_FALSE(only<Initial>(component_with("initial off;")).modes[0].probability);
}

TEST(PlantParse, TransitionsWithAllClauses) {
  const auto t =
      only<TransitionText>(component_with("a, b -> c when x in {u, v} in [30 s, 60] ~ normal(45 s, 5) with 0.5;"));
  EXPECT_EQ(std::get<NamedSources>(t.sources.node).modes.size(), 2u);
  ASSERT_EQ(t.branches.size(), 1u);
  EXPECT_EQ(t.branches[0].target.text, "c");
  EXPECT_EQ(std::get<ProbabilityWeight>(*t.branches[0].weight).probability.value, 0.5);
  EXPECT_EQ(test::tree(*t.guard), "x in {u v}");
  EXPECT_EQ(t.timing->lower.text(), "30s");
  EXPECT_EQ(t.timing->upper.text(), "60");
  EXPECT_EQ(t.timing->density->kind, DensityKind::normal);
  EXPECT_EQ(t.timing->density->parameters.size(), 2u);
  EXPECT_FALSE(t.braced);
}

TEST(PlantParse, DensitiesOfANumberAndATime) {
  for (const auto& [text, kind] :
       {std::pair("weibull(1.5, 2 h)", DensityKind::weibull), std::pair("erlang(1.5, 2 h)", DensityKind::erlang)}) {
    const auto t = only<TransitionText>(component_with(std::string("a -> b in [0, inf] ~ ") + text + ";"));
    EXPECT_EQ(t.timing->density->kind, kind);
    EXPECT_EQ(t.timing->density->shape.value, 1.5);
    ASSERT_EQ(t.timing->density->parameters.size(), 1u);
  }
}

TEST(PlantParse, AfterIsAPointInTime) {
  const auto t = only<TransitionText>(component_with("a -> b after 5 min;"));
  EXPECT_TRUE(t.timing->after);
  EXPECT_EQ(t.timing->lower.text(), "5min");
  EXPECT_EQ(t.timing->upper.text(), "5min");
}

TEST(PlantParse, InfiniteBounds) {
  for (const char* spelling : {"inf", "∞"}) {
    const auto t =
        only<TransitionText>(component_with(std::string("a -> b in [0, ") + spelling + "] ~ exponential(1 h);"));
    EXPECT_TRUE(t.timing->upper.infinite);
    EXPECT_EQ(t.timing->density->kind, DensityKind::exponential);
  }
}

TEST(PlantParse, AnySourcesAndRates) {
  const auto t = only<TransitionText>(component_with("any nominal -> lost with rate 1e-6 /h;"));
  EXPECT_TRUE(std::get<AnySource>(t.sources.node).nominal);
  EXPECT_EQ(std::get<RateWeight>(*t.branches[0].weight).unit.text, "h");
  EXPECT_FALSE(std::get<AnySource>(only<TransitionText>(component_with("any -> lost with 1;")).sources.node).nominal);
}

TEST(PlantParse, BranchesTakeTheirClausesBeforeOrBehind) {
  for (const char* text :
       {"a -> { b with 0.9, c with 0.1 } when x = y in [1, 2];",
        "a -> when x = y in [1, 2] { b with 0.9, c with 0.1 };", "a -> when x = y { b with 0.9, c with 0.1 };",
        "a -> in [1, 2] { b with 0.9, c with 0.1 };"}) {
    const auto t = only<TransitionText>(component_with(text));
    EXPECT_TRUE(t.braced) << text;
    ASSERT_EQ(t.branches.size(), 2u) << text;
    EXPECT_EQ(t.branches[1].target.text, "c") << text;
    EXPECT_TRUE(t.guard || t.timing) << text;
  }
}

TEST(PlantParse, KeywordsNameModesAndInstances) {
  const auto result =
      component_with("initial -> fault; mode, fault -> mode after 1; mode mode; fault fault; after -> after;");
  ASSERT_TRUE(result.tree) << result.errors();
  const Parsed<PlantFile> plant(parse_plant, "plant plant { control : Valve; input, output : Valve; control = x; }");
  EXPECT_TRUE(plant.tree) << plant.errors();
}

TEST(PlantParse, PlacesAreTheStatements) {
  const Parsed<PlantFile> result = component_with("  off -> on when x = y;  ");
  const auto t = only<TransitionText>(result);
  EXPECT_EQ(result.sources.text(t.span), "off -> on when x = y;");
  EXPECT_EQ(result.sources.text(t.branches[0].target.span), "on");
}

}  // namespace
}  // namespace rmpl::grammar
