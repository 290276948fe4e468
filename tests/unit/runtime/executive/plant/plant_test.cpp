// Simulated plants: same seed, same plant; drawn as the model says; dictated where the scenario dictates.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "runtime/executive/plant/random_source.hpp"
#include "runtime/executive/plant/scripted_plant.hpp"
#include "runtime/executive/plant/simulated_plant.hpp"
#include "tests/unit/runtime/executive/cycle/heater.hpp"

namespace rmpl::runtime {
namespace {

using namespace rmpl::automata;
using namespace heater;

constexpr Ticks half_second{Ticks::per_second / 2};

// Bytes that must never change: a seed is a promise.
TEST(RandomSource, IsTheSameOnEveryMachine) {
  RandomSource source(7, 1);
  const std::vector<std::uint64_t> drawn{source.next(), source.next(), source.next()};
  RandomSource again(7, 1);
  for (const std::uint64_t number : drawn) EXPECT_EQ(again.next(), number);
  EXPECT_NE(RandomSource(7, 2).next(), drawn[0]);
  EXPECT_NE(RandomSource(8, 1).next(), drawn[0]);
}

TEST(RandomSource, DrawsUniformly) {
  RandomSource source(1);
  std::vector<int> counts(5);
  double sum = 0;
  for (int i = 0; i < 50'000; ++i) {
    ++counts[source.below(5)];
    const double u = source.uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
  }
  for (const int count : counts) EXPECT_NEAR(count, 10'000, 500);
  EXPECT_NEAR(sum / 50'000, 0.5, 0.01);
}

TEST(SimulatedPlant, FollowsTheModel) {
  const Plant model = heater::plant();
  const Scenario scenario = heater::scenario();
  PlantStep step(model);
  SimulatedPlant plant(step, scenario, 1);
  EXPECT_EQ(*plant.truth(), Modes{off});
  plant.issue({turn_on}, Ticks{});
  EXPECT_EQ(plant.sense(half_second), (Observation{{temp, low}}));
  EXPECT_EQ(*plant.truth(), Modes{heating});
  for (int i = 1; i < 4; ++i) {
    plant.issue({none}, {half_second.count * i});
    plant.sense({half_second.count * (i + 1)});
    EXPECT_EQ(*plant.truth(), Modes{heating}) << i;
  }
  plant.issue({none}, {half_second.count * 4});
  EXPECT_EQ(plant.sense({half_second.count * 5}), (Observation{{temp, high}}));
  EXPECT_EQ(*plant.truth(), Modes{on});
}

TEST(SimulatedPlant, ForcesModesInTheFirstStepThatEndsAtTheirTimeOrLater) {
  const Plant model = heater::plant();
  Scenario scenario = heater::scenario();
  scenario.forced = {{{700'000'000}, component, broken, {}}};
  PlantStep step(model);
  SimulatedPlant plant(step, scenario, 1);
  plant.sense(half_second);
  EXPECT_EQ(*plant.truth(), Modes{off});
  EXPECT_TRUE(plant.more_to_come());
  plant.sense({half_second.count * 2});
  EXPECT_EQ(*plant.truth(), Modes{broken});
  ASSERT_EQ(plant.happenings().size(), 1U);
  EXPECT_EQ(plant.happenings()[0].message, "heater = broken");
  EXPECT_FALSE(plant.more_to_come());
}

/// A heater that breaks only where it is on: what is awaited from 0.7 s on happens after 2.5 s, once, in the next step.
TEST(SimulatedPlant, WaitsForTheFirstStepInWhichTheModelHasAFault) {
  Plant model = heater::plant();
  std::erase_if(model.components[0].transitions,
                [](const Transition& transition) { return transition.to == broken && transition.from != on; });
  PlantStep step(model);
  SimulatedPlant plant(step, heater::scenario(), 1, {{{700'000'000}, component, broken, {}}});
  plant.issue({turn_on}, Ticks{});
  plant.sense(half_second);
  plant.issue({none}, half_second);
  for (int i = 1; i < 5; ++i) {
    plant.sense({half_second.count * (i + 1)});
    EXPECT_EQ(*plant.truth(), Modes{i < 4 ? heating : on}) << i;
    EXPECT_TRUE(plant.more_to_come());
  }
  plant.sense({half_second.count * 6});
  EXPECT_EQ(*plant.truth(), Modes{broken});
  ASSERT_EQ(plant.happenings().size(), 1U);
  EXPECT_EQ(plant.happenings()[0].message, "heater = broken");
  EXPECT_FALSE(plant.more_to_come());
}

TEST(SimulatedPlant, TakesTheInitialModesThatAreGiven) {
  const Plant model = heater::plant();
  Scenario scenario = heater::scenario();
  scenario.truth = {in(on)};
  PlantStep step(model);
  EXPECT_EQ(*SimulatedPlant(step, scenario, 1).truth(), Modes{on});
}

TEST(SimulatedPlant, SaysSoWhereNoStateIsConsistent) {
  Plant model = heater::plant();
  model.interconnections.push_back(is(temp, high));
  PlantStep step(model);
  EXPECT_THROW(SimulatedPlant(step, heater::scenario(), 1), base::InputError);
}

/// The heater may neither heat nor break: all that can follow is looked at, and few draws are made in vain. Where it
/// may break it goes on, as rarely as that comes.
TEST(SimulatedPlant, LooksWhetherAnythingCanFollow) {
  Plant model = heater::plant();
  for (Transition& t : model.components[0].transitions) {
    if (t.weight.kind == Weight::Kind::rate) t.weight = {Weight::Kind::probability, 0.001};
  }
  model.interconnections.push_back(negation(is(mode, ValueId(heating.index()))));
  PlantStep step(model);
  const Scenario scenario = heater::scenario();
  SimulatedPlant plant(step, scenario, 1);
  plant.issue({turn_on}, Ticks{});
  plant.sense(half_second);
  EXPECT_EQ(*plant.truth(), Modes{broken});
  model.interconnections.push_back(negation(is(mode, ValueId(broken.index()))));
  PlantStep dead_end(model);
  SimulatedPlant stuck(dead_end, scenario, 1);
  stuck.issue({turn_on}, Ticks{});
  try {
    stuck.sense(half_second);
    FAIL() << "something followed";
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("each of 256"), std::string::npos) << error.what();
  }
}

/// A component whose one mode leaves two connected sensors free: both read alike.
TEST(SimulatedPlant, DrawsFreeReadingsJointlyConsistentAndEvenly) {
  Plant model = heater::plant();
  model.components[0].modes[off.index()].constraint = constant(true);
  const VariableId twin = model.variables.add({"twin", {"low", "high"}});
  model.interconnections.push_back(equality(temp, twin));
  model.observables.push_back(twin);
  const Scenario scenario = heater::scenario();
  PlantStep step(model);
  SimulatedPlant plant(step, scenario, 3);
  int highs = 0;
  for (int i = 1; i <= 2000; ++i) {
    const Observation& readings = plant.sense({half_second.count * i});
    ASSERT_EQ(readings.size(), 2U);
    ASSERT_EQ(readings[0].value, readings[1].value);
    if (readings[0].value == high) ++highs;
  }
  EXPECT_NEAR(highs, 1000, 100);
}

/// Two heaters, of which the first breaks by force in one flight: with its luck the second does, in a flight without
/// that, what it did; and to note the numbers changes none.
TEST(SimulatedPlant, FollowsTheLuckOfAnotherFlight) {
  Plant model = heater::plant();
  Component second = model.components[0];
  second.name = "second";
  second.mode = model.variables.add({"second", {"off", "heating", "on", "broken"}});
  for (Mode& mode : second.modes) mode.constraint = constant(true);
  for (Transition& transition : second.transitions) {
    transition.guard = constant(true);
    if (transition.timing) transition.timing->upper = {transition.timing->lower.count + 8 * Ticks::per_second};
  }
  model.components.push_back(second);
  Scenario hurt = heater::scenario();
  hurt.forced = {{{700'000'000}, component, broken, {}}};
  int parted = 0;
  PlantStep step(model);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto luck = std::make_shared<Luck>();
    SimulatedPlant plain(step, hurt, seed);
    SimulatedPlant noted(step, hurt, seed, {}, {luck, nullptr});
    std::vector<Modes> flown;
    for (int i = 1; i <= 30; ++i) {
      const Ticks now{half_second.count * i};
      EXPECT_EQ(plain.sense(now), noted.sense(now));
      EXPECT_EQ(*plain.truth(), *noted.truth());
      flown.push_back(*noted.truth());
    }
    SimulatedPlant twin(step, heater::scenario(), seed, {}, {nullptr, luck});
    SimulatedPlant other(step, heater::scenario(), seed);
    bool same = true;
    for (int i = 1; i <= 30; ++i) {
      twin.sense({half_second.count * i});
      other.sense({half_second.count * i});
      EXPECT_EQ((*twin.truth())[1], flown[static_cast<std::size_t>(i) - 1][1]) << seed << " " << i;
      same = same && (*other.truth())[1] == flown[static_cast<std::size_t>(i) - 1][1];
    }
    if (!same) ++parted;
  }
  EXPECT_GT(parted, 0);  // else the test shows nothing
}

TEST(SimulatedPlant, RepeatsWithItsSeed) {
  Plant model = heater::plant();
  for (Transition& t : model.components[0].transitions) {
    if (t.weight.kind == Weight::Kind::rate) t.weight.value = 0.3;
  }
  const Scenario scenario = heater::scenario();
  PlantStep step(model);
  const auto history = [&](std::uint64_t seed) {
    SimulatedPlant plant(step, scenario, seed);
    std::vector<Modes> modes;
    for (int i = 1; i <= 40; ++i) {
      plant.issue({i % 5 == 0 ? turn_off : turn_on}, {half_second.count * (i - 1)});
      plant.sense({half_second.count * i});
      modes.push_back(*plant.truth());
    }
    return modes;
  };
  EXPECT_EQ(history(5), history(5));
  EXPECT_NE(history(5), history(6));
}

/// A monitor of the heater's temperature: low below 20, high from 25 on, stale after 2 s.
Scenario sampled() {
  Scenario scenario = heater::scenario();
  Monitor monitor;
  monitor.channel = "T";
  monitor.attribute = temp;
  Band cold, warm;
  cold.value = low;
  cold.to = 20;
  cold.open_to = true;
  warm.value = high;
  warm.from = 25;
  monitor.bands = {cold, warm};
  monitor.stale = Ticks::of_seconds(2);
  scenario.monitors = {monitor};
  return scenario;
}

TEST(ScriptedPlant, SamplesOfChannelsBecomeReadings) {
  const Plant model = heater::plant();
  Scenario scenario = sampled();
  scenario.samples = {{Ticks::of_seconds(5), "T", 22.0, "22", {}},  // in a gap
                      {Ticks::of_seconds(1), "T", 30.0, "30", {}},
                      {Ticks{1'200'000'000}, "T", std::nullopt, "19", {}},
                      {Ticks::of_seconds(6), "T", std::nullopt, "n/a", {}}};
  scenario.overrides = {{Ticks::of_seconds(2), half_second, {temp, high}, {}}};
  ScriptedPlant plant(model, scenario);
  EXPECT_TRUE(plant.sense(half_second).empty());
  EXPECT_TRUE(plant.samples().empty());
  EXPECT_EQ(plant.sense(Ticks::of_seconds(1)), (Observation{{temp, high}}));
  // A text that reads as a number is one.
  EXPECT_EQ(plant.sense(Ticks{1'500'000'000}), (Observation{{temp, low}}));
  ASSERT_EQ(plant.samples().size(), 1U);
  EXPECT_EQ(plant.samples().front().number, 19);
  // What is dictated goes before; after it the monitor is heard again, until it is stale.
  EXPECT_EQ(plant.sense(Ticks::of_seconds(2)), (Observation{{temp, high}}));
  EXPECT_EQ(plant.sense(Ticks::of_seconds(3)), (Observation{{temp, low}}));
  EXPECT_TRUE(plant.sense(Ticks{3'500'000'000}).empty());
  EXPECT_TRUE(plant.sense(Ticks::of_seconds(5)).empty());
  EXPECT_TRUE(plant.happenings().empty());
  EXPECT_TRUE(plant.more_to_come());
  EXPECT_TRUE(plant.sense(Ticks::of_seconds(6)).empty());
  EXPECT_EQ(plant.happenings().size(), 1U);
  EXPECT_FALSE(plant.more_to_come());
}

TEST(SimulatedPlant, SensorsReadUntilTheFirstSample) {
  const Plant model = heater::plant();
  Scenario scenario = sampled();
  scenario.samples = {{Ticks::of_seconds(1), "T", 22.0, "22", {}}};
  PlantStep step(model);
  SimulatedPlant plant(step, scenario, 3);
  EXPECT_EQ(plant.sense(half_second).size(), 1U);
  EXPECT_TRUE(plant.sense(Ticks::of_seconds(1)).empty());
  scenario.monitors.clear();
  EXPECT_THROW(SimulatedPlant(step, scenario, 3), base::InputError);
}

// Thesis 7.2.1: 86 cycles of half a second after the standby command are 43 s.
TEST(ScriptedPlant, RulesAnswerACommandSomeCyclesLater) {
  const Plant model = heater::plant();
  Scenario scenario = heater::scenario();
  Rule rule;
  rule.trigger = is(cmd, turn_on);
  rule.delay_cycles = 86;
  rule.reading = {temp, high};
  scenario.rules = {rule};
  ScriptedPlant plant(model, scenario);
  EXPECT_EQ(plant.truth(), nullptr);
  plant.issue({turn_on}, Ticks{});
  EXPECT_TRUE(plant.sense({42'500'000'000}).empty());
  EXPECT_EQ(plant.sense({43'000'000'000}), (Observation{{temp, high}}));
  EXPECT_EQ(plant.sense({80'000'000'000}), (Observation{{temp, high}}));
}

// For one cycle means in one reading, whichever it is.
TEST(ScriptedPlant, NothingIsReadSoonerThanAtTheEndOfTheSameCycle) {
  const Plant model = heater::plant();
  for (const std::uint64_t delay : {0u, 1u, 2u}) {
    Scenario scenario = heater::scenario();
    Rule rule;
    rule.trigger = is(cmd, turn_on);
    rule.delay_cycles = delay;
    rule.duration = half_second;
    rule.reading = {temp, low};
    scenario.rules.push_back(rule);
    ScriptedPlant plant(model, scenario);
    plant.issue({turn_on}, Ticks{});
    const auto first = static_cast<std::int64_t>(std::max<std::uint64_t>(delay, 1));
    for (std::int64_t reading = 1; reading < 4; ++reading) {
      EXPECT_EQ(plant.sense({half_second.count * reading}).empty(), reading != first) << delay << ", " << reading;
    }
  }
}

TEST(ScriptedPlant, ARuleFiresWhereTheCommandBeginsToHold) {
  const Plant model = heater::plant();
  Scenario scenario = heater::scenario();
  Rule rule;
  rule.trigger = is(cmd, turn_on);
  rule.delay = Ticks::of_seconds(2);
  rule.duration = Ticks::of_seconds(1);
  rule.reading = {temp, high};
  scenario.rules = {rule};
  ScriptedPlant plant(model, scenario);
  plant.issue({turn_on}, Ticks{});
  plant.issue({turn_on}, Ticks::of_seconds(1));  // goes on: does not fire again
  EXPECT_FALSE(plant.sense(Ticks::of_seconds(2)).empty());
  EXPECT_TRUE(plant.sense(Ticks::of_seconds(3)).empty());
  plant.issue({none}, Ticks::of_seconds(3));
  plant.issue({turn_on}, Ticks::of_seconds(4));
  EXPECT_TRUE(plant.more_to_come());
  EXPECT_FALSE(plant.sense(Ticks::of_seconds(6)).empty());
}

TEST(ScriptedPlant, RulesHearTheEstimate) {
  const Plant model = heater::plant();
  Scenario scenario = heater::scenario();
  Rule rule;
  rule.stream = Rule::Stream::estimate;
  rule.trigger = is(mode, ValueId(heating.index()));
  rule.reading = {temp, low};
  scenario.rules = {rule};
  ScriptedPlant plant(model, scenario);
  plant.overhear({off}, Ticks{});
  EXPECT_TRUE(plant.sense(half_second).empty());
  plant.overhear({heating}, half_second);
  EXPECT_EQ(plant.sense({half_second.count * 2}), (Observation{{temp, low}}));
}

// What began last is heard; when it ends, what still holds is heard again.
TEST(ScriptedPlant, LaterReadingsCoverEarlierOnes) {
  const Plant model = heater::plant();
  Scenario scenario = heater::scenario();
  scenario.overrides = {{Ticks::of_seconds(1), Ticks::infinite(), {temp, low}, {}},
                        {Ticks::of_seconds(3), Ticks::of_seconds(2), {temp, high}, {}}};
  ScriptedPlant plant(model, scenario);
  EXPECT_TRUE(plant.sense(half_second).empty());
  EXPECT_EQ(plant.sense(Ticks::of_seconds(1)), (Observation{{temp, low}}));
  EXPECT_EQ(plant.sense(Ticks::of_seconds(3)), (Observation{{temp, high}}));
  EXPECT_EQ(plant.sense(Ticks::of_seconds(4)), (Observation{{temp, high}}));
  EXPECT_EQ(plant.sense(Ticks::of_seconds(5)), (Observation{{temp, low}}));
}

}  // namespace
}  // namespace rmpl::runtime
