// The executive on a small plant: the order of a cycle, and what happens where things go wrong.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "runtime/executive/cycle/executive.hpp"
#include "runtime/executive/cycle/message_queue.hpp"
#include "runtime/executive/plant/scripted_plant.hpp"
#include "runtime/executive/plant/simulated_plant.hpp"
#include "tests/unit/runtime/executive/cycle/heater.hpp"

namespace rmpl::runtime {
namespace {

using namespace rmpl::automata;
using namespace heater;

/// Everything that an executive is made of.
struct Flight {
  explicit Flight(const Scenario& flown, Program flown_program = heater::program())
      : scenario(flown),
        program(std::move(flown_program)),
        estimator(make_exact_estimator(step, {.live_clocks_only = true})),
        reconfigurer(make_reconfigurer(step)),
        plant(scenario.rules_only ? std::unique_ptr<PlantInterface>(std::make_unique<ScriptedPlant>(model, scenario))
                                  : std::make_unique<SimulatedPlant>(flown_step, scenario, 1)),
        executive(program, model, *estimator, *reconfigurer, *plant, clock, scenario.cycle) {}

  Scenario scenario;
  Program program;
  Plant model = heater::plant();
  PlantStep step{model};
  PlantStep flown_step{model};
  std::unique_ptr<Estimator> estimator;
  std::unique_ptr<Reconfigurer> reconfigurer;
  std::unique_ptr<PlantInterface> plant;
  SimulatedClock clock;
  Executive executive;
};

TEST(MessageQueue, IsFirstInFirstOut) {
  MessageQueue<int> queue;
  EXPECT_FALSE(queue.pop());
  queue.push(1);
  queue.push(2);
  EXPECT_EQ(queue.pop(), 1);
  queue.push(3);
  EXPECT_EQ(queue.pop(), 2);
  EXPECT_EQ(queue.pop(), 3);
  EXPECT_FALSE(queue.pop());
}

TEST(Executive, AchievesAGoalThroughATimedTransitionAndEnds) {
  Flight flight(heater::scenario());
  EXPECT_EQ(flight.executive.record().cycle, 0U);
  EXPECT_EQ(flight.executive.record().estimate, Modes{off});

  const CycleRecord& first = flight.executive.run_cycle();
  EXPECT_EQ(first.cycle, 1U);
  EXPECT_EQ(first.start, Ticks{});
  EXPECT_EQ(first.time, Ticks{Ticks::per_second / 2});
  EXPECT_EQ(first.marking, (Marking{LocationId(0), LocationId(1)}));
  EXPECT_EQ(first.goals.goal, std::vector<Assignment>{in(on)});
  EXPECT_EQ(first.command, ControlAction{turn_on});
  EXPECT_EQ(first.observations, (Observation{{temp, low}}));
  EXPECT_EQ(first.estimate, Modes{heating});
  EXPECT_EQ(*first.truth, Modes{heating});

  for (int i = 2; i <= 5; ++i) {
    EXPECT_FALSE(flight.executive.ended());
    EXPECT_EQ(flight.executive.run_cycle().command, ControlAction{none}) << i;
  }
  EXPECT_EQ(flight.executive.record().estimate, Modes{on});
  EXPECT_TRUE(flight.executive.ended());
  EXPECT_TRUE(flight.executive.run_cycle().goals.empty());
}

// The simulated heater breaks; that it stays cold is the evidence; off repairs it, and it is turned on again.
TEST(Executive, DiagnosesAFaultAndRepairsIt) {
  Scenario scenario = heater::scenario();
  scenario.forced = {{Ticks::of_seconds(1), component, broken, {}}};
  Flight flight(scenario);
  std::vector<ControlAction> commands;
  std::vector<Modes> estimates;
  for (int i = 0; i < 30 && !flight.executive.ended(); ++i) {
    const CycleRecord& record = flight.executive.run_cycle();
    if (record.command != ControlAction{none}) commands.push_back(record.command);
    if (estimates.empty() || estimates.back() != record.estimate) estimates.push_back(record.estimate);
  }
  EXPECT_EQ(commands, (std::vector<ControlAction>{{turn_on}, {turn_off}, {turn_on}}));
  EXPECT_EQ(estimates, (std::vector<Modes>{{heating}, {broken}, {off}, {heating}, {on}}));
  EXPECT_TRUE(flight.executive.ended());
}

TEST(Executive, GoalsThatContradictLeaveTheCommandIdleAndTheRunGoesOn) {
  Program program = heater::program();
  program.locations.push_back(program.locations[1]);
  program.locations[2].goal = {in(off)};
  Flight flight(heater::scenario(), program);
  const CycleRecord& record = flight.executive.run_cycle();
  EXPECT_TRUE(record.goals.empty());
  EXPECT_EQ(record.command, ControlAction{none});
  ASSERT_EQ(record.events.size(), 1U);
  EXPECT_EQ(record.events[0].kind, Event::Kind::goal_conflict);
  // `heater = off` is the case, so its location is done, and what is left agrees with itself.
  EXPECT_EQ(flight.executive.run_cycle().command, ControlAction{turn_on});
}

TEST(Executive, NoPlanIsAnEventAndTheCommandIsIdle) {
  Program program = heater::program();
  program.locations[1].goal = {in(broken)};
  Flight flight(heater::scenario(), program);
  const CycleRecord& record = flight.executive.run_cycle();
  EXPECT_EQ(record.command, ControlAction{none});
  ASSERT_EQ(record.events.size(), 1U);
  EXPECT_EQ(record.events[0].kind, Event::Kind::no_plan);
  EXPECT_FALSE(record.events[0].message.empty());
}

// No mode that the heater can be in explains the warmth: the estimate is a prediction, and the sequencer, which
// waits for the warmth, does not see it.
TEST(Executive, ObservationsThatNothingExplainsAreNotHandedToTheSequencer) {
  Scenario scenario = heater::scenario();
  scenario.rules_only = true;
  scenario.overrides = {{Ticks{}, Ticks::infinite(), {temp, high}, {}}};
  Program program = heater::program();
  program.locations[1].goal.clear();
  program.locations[1].arcs = {{{false, is(temp, high)}, LocationId(1)}};
  Flight flight(scenario, program);
  const CycleRecord& record = flight.executive.run_cycle();
  EXPECT_FALSE(record.consistent);
  EXPECT_EQ(record.estimate, Modes{off});
  ASSERT_EQ(record.events.size(), 1U);
  EXPECT_EQ(record.events[0].kind, Event::Kind::inconsistent);
  EXPECT_FALSE(flight.executive.ended());
  flight.executive.run_cycle();
  EXPECT_FALSE(flight.executive.ended());
}

TEST(PacedClock, IsWhereItWaitedToAndNotAheadOfTheWall) {
  const auto begin = std::chrono::steady_clock::now();
  PacedClock clock([] { return false; });
  EXPECT_EQ(clock.now(), Ticks{});
  clock.wait_until({2'000'000});
  EXPECT_EQ(clock.now(), (Ticks{2'000'000}));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(2));
}

TEST(PacedClock, AnInterruptionEndsAWait) {
  const auto begin = std::chrono::steady_clock::now();
  PacedClock clock([] { return true; });
  clock.wait_until(Ticks::of_seconds(3600));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::minutes(1));
}

}  // namespace
}  // namespace rmpl::runtime
