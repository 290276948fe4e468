// Which islands nothing contradicts, on a plant put together by hand.
// SPDX-License-Identifier: MIT
#include "automata/store/totality.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rmpl::automata {
namespace {

/// A source of current, a switch that a lever works, and a lamp, one after the other.
class Circuit : public testing::Test {
 protected:
  Circuit() {
    const std::vector<std::string> current = {"off", "low", "high"};
    lever = plant.variables.add({"lever", {"none", "up"}});
    supply = plant.variables.add({"source.out", current});
    in = plant.variables.add({"switch.in", current});
    out = plant.variables.add({"switch.out", current});
    light = plant.variables.add({"lamp.light", current});
    for (const char* name : {"source", "switch"}) {
      const VariableId variable = plant.variables.add({name, {"good", "dead"}});
      plant.components.push_back({name, name, variable, {mode("good"), mode("dead")}, {1, 0}, {}, {}});
    }
    plant.components[0].modes[0].constraint = is(supply, ValueId(2));
    plant.components[1].modes[0].constraint =
        conjunction({implication(is(lever, ValueId(1)), equality(out, in)),
                     implication(negation(is(lever, ValueId(1))), is(out, ValueId(0)))});
    plant.interconnections = {equality(in, supply), equality(light, out)};
    plant.controls = {{lever, ValueId(0)}};
  }
  static Mode mode(const char* name) { return {name, false, constant(true), 0, {}}; }
  [[nodiscard]] bool total() const {
    const Locality locality(plant);
    const auto& islands = locality.islands();
    return std::all_of(islands.begin(), islands.end(), [&](const auto& island) { return is_total(plant, island); });
  }
  Plant plant;
  VariableId lever, supply, in, out, light;
};

TEST_F(Circuit, IsTotalWhereOutputsFollowFromInputs) { EXPECT_TRUE(total()); }

TEST_F(Circuit, IsNotWhereTwoSayWhatOneIs) {
  plant.interconnections.push_back(is(light, ValueId(1)));
  EXPECT_FALSE(total());
}

TEST_F(Circuit, IsNotWhereAControlIsRestricted) {
  plant.interconnections.push_back(is(lever, ValueId(0)));
  EXPECT_FALSE(total());
}

TEST_F(Circuit, IsNotWhereAModeIsImpossible) {
  plant.components[1].modes[1].constraint = constant(false);
  EXPECT_FALSE(total());
}

TEST_F(Circuit, IsNotWhereALoopHasNoFixedPoint) {
  plant.components[0].modes[0].constraint = equivalence(is(light, ValueId(0)), is(supply, ValueId(2)));
  EXPECT_FALSE(total());
}

TEST_F(Circuit, AsksASolverWhereValuesAreMany) {
  // One wire that each of many others may drive, one at a time: more combinations than are tried one by one.
  const VariableId turn = plant.variables.add({"turn", {"a", "b", "c", "d", "e", "f", "g", "h"}});
  const VariableId word = plant.variables.add({"word", {"off", "low", "high"}});
  for (std::size_t i = 0; i < 8; ++i) {
    const VariableId wire =
        plant.variables.add({std::string("wire") += static_cast<char>('a' + i), {"off", "low", "high"}});
    plant.interconnections.push_back(implication(is(turn, ValueId(i)), equality(word, wire)));
  }
  EXPECT_TRUE(total());
  // Two hands on the wire at once.
  plant.interconnections.push_back(implication(is(turn, ValueId(3)), is(word, ValueId(1))));
  plant.controls.push_back({turn, ValueId(0)});
  for (std::size_t i = 0; i < 8; ++i) {
    const auto wire = plant.variables.find(std::string("wire") += static_cast<char>('a' + i));
    plant.interconnections.push_back(is(*wire, ValueId(2)));
  }
  EXPECT_FALSE(total());
}

}  // namespace
}  // namespace rmpl::automata
