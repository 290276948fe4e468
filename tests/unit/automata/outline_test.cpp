// Types and instances, found again in flat plants.
// SPDX-License-Identifier: MIT
#include "automata/outline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "automata/instance.hpp"

namespace rmpl::automata {
namespace {

/// A component type as the compiler lowers it: its mode is named "".
Plant lamp_type() {
  Plant type;
  const auto mode = type.variables.add({"", {"off", "on"}});
  const auto light = type.variables.add({"light", {"no", "yes"}});
  Component lamp{"", "Lamp", mode, {}, {1, 0}, {}, {}};
  lamp.modes = {{"off", false, is(light, ValueId(0)), 0, {}}, {"on", false, is(light, ValueId(1)), 0, {}}};
  lamp.transitions = {{ModeId(0), ModeId(1), constant(true), {}, {}, 0, {}}};
  type.components.push_back(lamp);
  return type;
}

/// Two lamps that shine alike.
Plant pair_type() {
  Plant type;
  instantiate(type, "left", lamp_type());
  instantiate(type, "right", lamp_type());
  type.interconnections.emplace_back(equality(*type.variables.find("left.light"), *type.variables.find("right.light")));
  type.observables.push_back(*type.variables.find("left.light"));
  return type;
}

std::vector<std::string> types_of(const PlantOutline& outline) {
  std::vector<std::string> names;
  names.reserve(outline.types.size());
  for (const PlantType& type : outline.types) names.push_back(type.name);
  return names;
}

TEST(Outline, ComponentTypesAndModulesStandOnce) {
  Plant plant;
  plant.variables.add({"port", {"no", "yes"}});
  for (const char* name : {"a", "b", "c"}) instantiate(plant, name, pair_type());
  instantiate(plant, "d", lamp_type());
  plant.interconnections.emplace_back(equality(VariableId(0), *plant.variables.find("d.light")));
  const PlantOutline outline = outline_of(plant);
  EXPECT_THAT(types_of(outline), testing::ElementsAre("Lamp", "a"));
  EXPECT_EQ(outline.types[0].plant, lamp_type());
  EXPECT_EQ(outline.types[1].plant, pair_type());
  EXPECT_EQ(outline.types[1].parts.instances.size(), 2U);
  EXPECT_EQ(outline.types[1].parts.interconnections, 0U);
  EXPECT_EQ(outline.whole.variables, 1U);
  EXPECT_EQ(outline.whole.components, 0U);
  EXPECT_EQ(outline.whole.interconnections, 3U);
  EXPECT_EQ(outline.whole.observables, 3U);
  ASSERT_EQ(outline.whole.instances.size(), 4U);
  EXPECT_EQ(outline.whole.instances[2].name, "c");
  EXPECT_EQ(outline.whole.instances[2].type, 1U);
  EXPECT_EQ(outline.whole.instances[3].type, 0U);
}

TEST(Outline, AnInstanceMayStartElsewhere) {
  Plant plant;
  instantiate(plant, "a", lamp_type());
  instantiate(plant, "b", lamp_type());
  plant.components[1].initial = {0, 1};
  const PlantOutline outline = outline_of(plant);
  ASSERT_EQ(outline.types.size(), 1U);
  EXPECT_EQ(outline.types[0].plant.components[0].initial, (std::vector<double>{1, 0}));
  EXPECT_EQ(outline.whole.instances[0].initial, std::nullopt);
  EXPECT_EQ(outline.whole.instances[1].initial, (std::vector<double>{0, 1}));
}

TEST(Outline, WhatDiffersIsAnotherType) {
  Plant plant;
  instantiate(plant, "a", lamp_type());
  Plant bright = lamp_type();
  bright.components[0].modes[1].reward = 2;
  instantiate(plant, "b", bright);
  instantiate(plant, "c", bright);
  const PlantOutline outline = outline_of(plant);
  EXPECT_THAT(types_of(outline), testing::ElementsAre("Lamp", "Lamp-2"));
  EXPECT_EQ(outline.whole.instances[2].type, 1U);
}

TEST(Outline, PartsThatSpeakOfEachOtherAreNoInstances) {
  Plant plant;
  instantiate(plant, "a", lamp_type());
  instantiate(plant, "b", lamp_type());
  plant.components[0].transitions[0].guard = is(plant.components[1].mode, ValueId(1));
  const PlantOutline outline = outline_of(plant);
  EXPECT_TRUE(outline.types.empty());
  EXPECT_EQ(outline.whole.components, 2U);
  EXPECT_EQ(outline.whole.variables, 4U);
}

TEST(Outline, WhatWouldComeBackUnderAnotherNameIsNoInstance) {
  for (const std::vector<std::string>& names : std::vector<std::vector<std::string>>{
           {"a", "c", "a.x"}, {"c", "a."}, {"c", "c."}, {"", "c", "c."}, {"c", "a.x", "b", "a.y"}, {".a", "c"}}) {
    Plant plant;
    for (const std::string& name : names) plant.variables.add({name, {"off", "on"}});
    Component component = lamp_type().components.front();
    component.mode = *plant.variables.find("c");
    component.name = plant.variables.name(component.mode);
    for (Mode& mode : component.modes) mode.constraint = constant(true);
    plant.components.push_back(component);
    const PlantOutline outline = outline_of(plant);
    EXPECT_TRUE(outline.types.empty()) << names.back();
    EXPECT_EQ(outline.whole.variables, names.size());
  }
}

TEST(Outline, AModuleWithoutComponentsHasItsInterconnections) {
  Plant wire;
  const auto in = wire.variables.add({"in", {"no", "yes"}});
  const auto out = wire.variables.add({"out", {"no", "yes"}});
  wire.interconnections.emplace_back(equality(in, out));
  Plant plant;
  for (const char* name : {"v", "w"}) instantiate(plant, name, wire);
  for (const char* name : {"a", "b"}) instantiate(plant, name, pair_type());
  const PlantOutline outline = outline_of(plant);
  EXPECT_THAT(types_of(outline), testing::ElementsAre("v", "Lamp", "a"));
  EXPECT_EQ(outline.types[0].plant, wire);
  EXPECT_EQ(outline.whole.interconnections, 4U);
}

TEST(Outline, NamesWithManyDotsAreNoModules) {
  Plant plant;
  std::string path = "a";
  for (std::size_t i = 0; i < 100'000; ++i) path += ".a";
  instantiate(plant, path, lamp_type());
  EXPECT_LT(outline_of(plant).types.size(), 1000U);
}

}  // namespace
}  // namespace rmpl::automata
