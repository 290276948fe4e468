// The rules of semantics 3, one by one, on a heater worked by hand.
// SPDX-License-Identifier: MIT
#include "automata/step/plant_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rmpl::automata {
namespace {

Ticks s(double seconds) { return *ticks_from_seconds(seconds); }

/// One component `heater`: off, warming, warm, broken (fault), stuck (fault); a sensor `temp`.
class Heater : public testing::Test {
 protected:
  enum : std::size_t { off, warming, warm, broken, stuck };
  Heater() {
    const auto mode = plant.variables.add({"heater", {"off", "warming", "warm", "broken", "stuck"}});
    cmd = plant.variables.add({"heater.cmd", {"none", "on", "off"}});
    temp = plant.variables.add({"heater.temp", {"low", "high"}});
    Component heater{"heater", "Heater", mode, {}, {1, 0, 0, 0, 0}, {}, {}};
    heater.modes = {{"off", false, is(temp, ValueId(0)), 0, {}},
                    {"warming", false, constant(true), 0, {}},
                    {"warm", false, is(temp, ValueId(1)), 0, {}},
                    {"broken", true, constant(true), 0, {}},
                    {"stuck", true, is(temp, ValueId(0)), 0, {}}};
    plant.components.push_back(heater);
    plant.controls.push_back({cmd, ValueId(0)});
    plant.observables.push_back(temp);
  }

  void add(std::size_t from, std::size_t to, Formula guard, std::optional<Timing> timing = {}, Weight weight = {},
           std::uint32_t branch = 0) {
    plant.components[0].transitions.push_back(
        {ModeId(from), ModeId(to), std::move(guard), timing, weight, branch != 0 ? branch : next_branch++, {}});
  }
  static Weight p(double value) { return {Weight::Kind::probability, value}; }

  std::vector<double> step(std::size_t mode, std::size_t command, double from, double to) {
    PlantStep plant_step(plant);
    const auto moves = plant_step.moves({{ModeId(mode)}, {s(0)}}, {ValueId(command)}, s(from), s(to));
    std::vector<double> by_mode(5, 0.0);
    for (const Move& move : moves[0]) by_mode[move.mode.index()] = move.probability;
    return by_mode;
  }
  static void expect(const std::vector<double>& got, const std::vector<double>& want) {
    for (std::size_t m = 0; m < want.size(); ++m) EXPECT_NEAR(got[m], want[m], 1e-12) << "mode " << m;
  }

  Plant plant;
  VariableId cmd, temp;
  std::uint32_t next_branch = 100;
};

TEST_F(Heater, UntimedTransitionTakesTheNominalShare) {
  add(off, warming, is(cmd, ValueId(1)));
  add(off, broken, constant(true), {}, p(0.01));
  add(off, stuck, constant(true), {}, {Weight::Kind::rate, 0.2});
  const double rate = 1 - std::exp(-0.1);
  expect(step(off, 1, 0, 0.5), {0, 1 - 0.01 - rate, 0, 0.01, rate});
  expect(step(off, 0, 0, 0.5), {1 - 0.01 - rate, 0, 0, 0.01, rate});
}

TEST_F(Heater, WeightsShareWhatSeveralUntimedTake) {
  add(off, warming, constant(true), {}, p(0.3));
  add(off, warm, constant(true), {}, p(0.1));
  expect(step(off, 0, 0, 1), {0, 0.75, 0.25, 0, 0});
}

TEST_F(Heater, TimedTransitionsCompeteAsIndependentRisks) {
  add(warming, warm, constant(true), Timing{s(0), s(10), {}});
  add(warming, off, constant(true), Timing{s(0), s(20), {}});
  add(warming, broken, constant(true), {}, p(0.1));
  const double a = 0.8, b = 0.9;  // survivals of the step from 0 to 2
  const double fires = 1 - a * b;
  const double ha = -std::log(a), hb = -std::log(b);
  expect(step(warming, 0, 0, 2), {0.9 * fires * hb / (ha + hb), 0.9 * a * b, 0.9 * fires * ha / (ha + hb), 0.1, 0});
  expect(step(warming, 0, 9, 10), {0, 0, 0.9, 0.1, 0});
}

TEST_F(Heater, SeveralCertainOnesShareEqually) {
  add(warming, warm, constant(true), Timing{s(0), s(5), {}});
  add(warming, off, constant(true), Timing{s(4), s(4), {}});
  add(warming, stuck, constant(true), {}, p(0.2));
  expect(step(warming, 0, 6, 7), {0.4, 0, 0.4, 0, 0.2});
}

TEST_F(Heater, TimedBranchIsOneRisk) {
  add(warming, warm, constant(true), Timing{s(0), s(10), {}}, p(0.9), 1);
  add(warming, off, constant(true), Timing{s(0), s(10), {}}, p(0.1), 1);
  expect(step(warming, 0, 0, 2), {0.02, 0.8, 0.18, 0, 0});
}

TEST_F(Heater, UntimedLeavesNothingToTimed) {
  add(warming, warm, constant(true), Timing{s(0), s(10), {}});
  add(warming, off, is(cmd, ValueId(2)));
  expect(step(warming, 2, 0, 2), {1, 0, 0, 0, 0});
}

TEST_F(Heater, ObservationFactor) {
  PlantStep plant_step(plant);
  const Observation high{{temp, ValueId(1)}};
  EXPECT_EQ(plant_step.observation_factor({ModeId(off)}, high), 0);
  EXPECT_EQ(plant_step.observation_factor({ModeId(warm)}, high), 1);
  EXPECT_EQ(plant_step.observation_factor({ModeId(broken)}, high), 0.5);
  EXPECT_EQ(plant_step.observation_factor({ModeId(off)}, {}), 1);
}

TEST_F(Heater, AStoreThatContradictsIsImpossible) {
  plant.interconnections.push_back(is(temp, ValueId(0)));
  PlantStep plant_step(plant);
  EXPECT_FALSE(plant_step.possible({ModeId(warm)}));
  EXPECT_EQ(plant_step.observation_factor({ModeId(warm)}, {}), 0);
  EXPECT_TRUE(plant_step.possible({ModeId(broken)}));
}

TEST_F(Heater, AClockRestartsWhenItsModeChanges) {
  const SystemState state{{ModeId(off)}, {s(3)}};
  PlantStep plant_step(plant);
  const ControlAction action = idle_action(plant);
  EXPECT_EQ(plant_step.advance(state, action, {ModeId(off)}, s(9)).clock_starts[0], s(3));
  EXPECT_EQ(plant_step.advance(state, action, {ModeId(warming)}, s(9)).clock_starts[0], s(9));
}

TEST_F(Heater, ARestartStartsTheClockOfItsModeAnew) {
  Component& heater = plant.components.front();
  heater.transitions.push_back({ModeId(warming), ModeId(warming), constant(true), {}, {}, 0, {}});
  const SystemState state{{ModeId(warming)}, {s(3)}};
  const ControlAction action = idle_action(plant);
  EXPECT_EQ(PlantStep(plant).advance(state, action, {ModeId(warming)}, s(9)).clock_starts[0], s(3));
  heater.transitions.back().restart = true;
  PlantStep plant_step(plant);
  EXPECT_EQ(plant_step.advance(state, action, {ModeId(warming)}, s(9)).clock_starts[0], s(9));
  EXPECT_TRUE(plant_step.restarted({ModeId(warming)}, action)[0]);
  EXPECT_FALSE(plant_step.restarted({ModeId(off)}, action)[0]);
  heater.transitions.back().weight = {Weight::Kind::probability, 0};  // never taken
  EXPECT_FALSE(PlantStep(plant).restarted({ModeId(warming)}, action)[0]);
}

}  // namespace
}  // namespace rmpl::automata
