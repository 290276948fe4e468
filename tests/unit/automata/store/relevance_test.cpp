// What can be left out of a small plant, and what cannot.
// SPDX-License-Identifier: MIT
#include "automata/store/relevance.hpp"

#include <gtest/gtest.h>

namespace rmpl::automata {
namespace {

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
  std::size_t values(VariableId v) const { return relevant_part(plant).variables[v].values.size(); }

  Plant plant;
  VariableId supply, current, meter, seal, cmd;
};

TEST_F(Pump, TelemetryIsLeftOutOneAfterTheOther) {
  const Plant part = relevant_part(plant);
  EXPECT_TRUE(part.interconnections.empty());
  EXPECT_TRUE(part.components[0].modes[0].constraint.is_true());
  EXPECT_TRUE(part.observables.empty());
  EXPECT_EQ(values(current), 1u);
  EXPECT_EQ(values(meter), 1u);
}

TEST_F(Pump, GuardsControlsAndModesStay) {
  EXPECT_EQ(values(supply), 2u);
  EXPECT_EQ(values(cmd), 2u);
  EXPECT_EQ(values(plant.components[0].mode), 2u);
  EXPECT_EQ(relevant_part(plant).components[0].transitions, plant.components[0].transitions);
}

TEST_F(Pump, WhatExcludesAModeStays) {
  plant.interconnections.push_back(is(meter, ValueId(2)));
  const Plant part = relevant_part(plant);
  EXPECT_EQ(values(current), 3u);
  EXPECT_FALSE(part.components[0].modes[0].constraint.is_true());
}

TEST_F(Pump, WhatAGuardDependsOnStays) {
  plant.components[0].modes[0].constraint = equality(supply, seal);
  plant.interconnections.push_back(is(seal, ValueId(1)));
  EXPECT_EQ(values(seal), 2u);
}

}  // namespace
}  // namespace rmpl::automata
