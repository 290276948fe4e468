// Campaigns: intervals against known values, draws that depend on seed and run alone, and what the counterfactual twin
// sees.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "runtime/executive/campaign/flight.hpp"
#include "runtime/executive/campaign/interval.hpp"
#include "tests/unit/runtime/executive/cycle/heater.hpp"

namespace rmpl::runtime {
namespace {

using namespace rmpl::automata;

TEST(ClopperPearson, IsAsInTables) {
  EXPECT_NEAR(clopper_pearson(0, 10).low, 0, 1e-12);
  EXPECT_NEAR(clopper_pearson(0, 10).high, 0.3084971, 1e-6);
  EXPECT_NEAR(clopper_pearson(5, 10).low, 0.1870860, 1e-6);
  EXPECT_NEAR(clopper_pearson(5, 10).high, 0.8129140, 1e-6);
  EXPECT_NEAR(clopper_pearson(10, 10).low, 0.6915029, 1e-6);
  EXPECT_NEAR(clopper_pearson(10, 10).high, 1, 1e-12);
  EXPECT_EQ(clopper_pearson(0, 0).low, 0);
  EXPECT_EQ(clopper_pearson(0, 0).high, 1);
}

TEST(Injections, DependOnSeedAndRunAlone) {
  const Plant plant = heater::plant();
  const CampaignPlan plan{7, 1, {}, 20};
  const Ticks cycle{Ticks::per_second / 2};
  std::set<std::int64_t> times;
  for (std::uint64_t run = 0; run < 2000; ++run) {
    const auto faults = injections(plan, plant, cycle, run);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults, injections(plan, plant, cycle, run));
    EXPECT_EQ(faults[0].mode, heater::broken);
    EXPECT_GE(faults[0].at, cycle);
    EXPECT_LE(faults[0].at.count, 20 * cycle.count);
    EXPECT_EQ(faults[0].at.count % cycle.count, 0);
    times.insert(faults[0].at.count);
  }
  EXPECT_EQ(times.size(), 20U);
}

TEST(Injections, AreEnumeratedEachAtEachTime) {
  const CampaignPlan plan{7, 0, {Ticks::of_seconds(1), Ticks::of_seconds(2)}, 20};
  const Ticks cycle{Ticks::per_second / 2};
  EXPECT_EQ(injections(plan, heater::plant(), cycle, 0)[0].at, Ticks::of_seconds(1));
  EXPECT_EQ(injections(plan, heater::plant(), cycle, 1)[0].at, Ticks::of_seconds(2));
  EXPECT_EQ(injections(plan, heater::plant(), cycle, 2)[0].at, Ticks::of_seconds(1));
}

/// The heater reads low until it is on, two seconds after the first cycle: broken before, it shows only then; broken
/// after, at once.
TEST(CampaignRun, TellsSymptomsFromFaults) {
  Document document;
  document.plants.push_back(heater::plant());
  document.programs.push_back(heater::program(true));
  Scenario scenario = heater::scenario();
  scenario.rules_only = false;
  scenario.duration = Ticks::of_seconds(20);
  for (const std::int64_t at : {1, 10}) {
    const CampaignPlan plan{7, 0, {Ticks::of_seconds(at)}, 20};
    const auto run = fly_run(document, scenario, plan, 0, {});
    ASSERT_TRUE(run);
    ASSERT_EQ(run->injected.size(), 1U);
    const Injected& injected = run->injected[0];
    EXPECT_EQ(injected.forced, Ticks::of_seconds(at));
    ASSERT_TRUE(injected.symptom);
    EXPECT_EQ(*injected.symptom, at == 10 ? Ticks::of_seconds(10) : Ticks{5 * Ticks::per_second / 2});
    ASSERT_TRUE(injected.named);
    EXPECT_GE(*injected.named, *injected.symptom);
    EXPECT_LT(run->right, run->cycles + 1);
  }
}

/// Off, the heater reads low, broken as well: a fault that comes by chance, to flight and twin alike, is no symptom of
/// the one injected.
TEST(Counterfactual, SuffersTheSameMischance) {
  const Plant plant = heater::plant();
  PlantStep step(plant);
  const SystemState state{{heater::on}, {Ticks{}}};
  const ControlAction idle{heater::none};
  const std::vector<Event> none;
  const Observation low{{heater::temp, heater::low}};
  const Ticks second = Ticks::of_seconds(1), two = Ticks::of_seconds(2);
  const Modes on{heater::on}, broken{heater::broken}, off{heater::off};
  Counterfactual injected(step, state, heater::component);
  EXPECT_TRUE(injected.contradicted_by({on, broken, idle, low, none, {}, second}));
  Counterfactual later(step, state, heater::component);
  EXPECT_FALSE(later.contradicted_by({on, off, idle, {{heater::temp, heater::high}}, none, {}, second}));
  EXPECT_FALSE(later.contradicted_by({off, broken, idle, low, none, second, two}));
}

}  // namespace
}  // namespace rmpl::runtime
