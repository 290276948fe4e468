// What of a small plant has to do with some of its variables, and what has not.
// SPDX-License-Identifier: MIT
#include "automata/store/relevance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rmpl::automata {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A pump with a guard on its supply; what it tells of itself; a pair of attributes that excludes a mode.
class Pump : public testing::Test {
 protected:
  Pump() {
    supply = plant.variables.add({"supply", {"off", "on"}});
    current = plant.variables.add({"current", {"zero", "low", "high"}});
    meter = plant.variables.add({"meter", {"zero", "low", "high"}});
    seal = plant.variables.add({"seal", {"dry", "wet"}});
    cmd = plant.variables.add({"cmd", {"none", "start"}});
    const auto mode = plant.variables.add({"pump", {"idle", "running"}});
    Component pump{"pump", "Pump", mode, {}, {1, 0}, {}, {}};
    pump.modes = {{"idle", false, is(current, ValueId(0)), 0, {}}, {"running", false, constant(true), 0, {}}};
    pump.transitions.push_back(
        {ModeId(0), ModeId(1), conjunction({is(cmd, ValueId(1)), is(supply, ValueId(1))}), {}, {}, 0, {}});
    plant.components.push_back(pump);
    plant.controls = {{cmd, ValueId(0)}};
    plant.interconnections = {equality(current, meter)};
    plant.observables = {meter, seal};
  }
  std::vector<VariableId> part(std::vector<VariableId> of) const { return Relevance(plant).part(of).variables; }

  Plant plant;
  VariableId supply, current, meter, seal, cmd;
};

TEST_F(Pump, EffectsAreNoCauses) {
  EXPECT_THAT(part({supply, cmd}), ElementsAre(supply, cmd));
  EXPECT_THAT(Relevance(plant).part({supply, cmd}).constraints, IsEmpty());
  EXPECT_FALSE(Relevance(plant).excludes());
}

TEST_F(Pump, CausesOfWhatIsAskedForAreThere) {
  const VariableId mode = plant.components[0].mode;
  EXPECT_THAT(part({meter}), ElementsAre(current, meter, mode));
  EXPECT_THAT(Relevance(plant).part({meter}).constraints, ElementsAre(0U, 1U));
}

TEST_F(Pump, WhatExcludesAModeStays) {
  plant.interconnections.push_back(is(meter, ValueId(2)));
  const VariableId mode = plant.components[0].mode;
  EXPECT_TRUE(Relevance(plant).excludes());
  EXPECT_THAT(part({mode}), ElementsAre(current, meter, mode));
}

TEST_F(Pump, OnePartAfterTheOther) {
  Relevance relevance(plant);
  const auto first = relevance.part({meter}).variables;
  relevance.part({supply});
  EXPECT_EQ(relevance.part({meter}).variables, first);
}

}  // namespace
}  // namespace rmpl::automata
