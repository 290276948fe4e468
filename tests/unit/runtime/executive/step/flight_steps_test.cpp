// Stepping: what may come, what is chosen, and that a session is the flight of its scenario.
// SPDX-License-Identifier: MIT
#include "runtime/executive/step/flight_steps.hpp"

#include <gmock/gmock.h>

#include "runtime/executive/step/scenario_text.hpp"
#include "tests/unit/runtime/executive/cycle/heater.hpp"

namespace rmpl::runtime {
namespace {

using namespace rmpl::automata;
using namespace heater;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Kind = Prospect::Kind;

std::vector<Kind> kinds(const std::vector<Prospect>& prospects) {
  std::vector<Kind> result;
  for (const Prospect& prospect : prospects) result.push_back(prospect.kind);
  return result;
}

/// Modes and readings, cycle by cycle.
class Record final : public CycleObserver {
 public:
  void observe(const CycleRecord& record) override {
    seen.push_back({*record.truth, record.estimate, record.command, record.observations});
  }
  struct Seen {
    Modes truth, estimate;
    ControlAction command;
    Observation observations;
    bool operator==(const Seen&) const = default;
  };
  std::vector<Seen> seen;
};

TEST(FlightSteps, TellsWhatMayCome) {
  const Document document = heater::document();
  FlightSteps steps(document, heater::scenario(), {});
  EXPECT_EQ(steps.stop().command, "heater.cmd = on");
  const auto start = steps.ahead();
  EXPECT_THAT(kinds(start), ElementsAre(Kind::command, Kind::command, Kind::transition, Kind::fault));
  EXPECT_THAT(start[1].lets, IsEmpty());
  EXPECT_GT(start[2].probability, 0.99);
  ASSERT_TRUE(steps.advance(nullptr));
  // From 0.5 s on it heats, until 2.5 s.
  const auto heating_up = steps.ahead();
  ASSERT_THAT(kinds(heating_up), ElementsAre(Kind::command, Kind::command, Kind::transition, Kind::fault));
  ASSERT_TRUE(heating_up[2].window);
  EXPECT_EQ(heating_up[2].window->from, (Ticks{2'500'000'000}));
  EXPECT_EQ(heating_up[2].probability, 0);
  EXPECT_FALSE(can_be_chosen(heating_up[2]));
}

TEST(FlightSteps, GoesBackToWhereItWas) {
  const Document document = heater::document();
  FlightSteps steps(document, heater::scenario(), {});
  for (int i = 0; i < 3; ++i) steps.advance(nullptr);
  const std::string here = to_text(steps.stop(), {});
  steps.force(component, broken);
  for (int i = 0; i < 4; ++i) steps.advance(nullptr);
  EXPECT_NE(to_text(steps.stop(), {}), here);
  steps.go_back_to(3);
  EXPECT_EQ(to_text(steps.stop(), {}), here);
  EXPECT_THAT(steps.choices(), IsEmpty());
  EXPECT_EQ(steps.position(), 3U);
}

TEST(FlightSteps, IsTheFlightOfItsScenario) {
  const Document document = heater::document(true);
  FlightSteps steps(document, heater::scenario(), {});
  Record stepped, flown;
  const auto go_on = [&](int cycles) {
    for (int i = 0; i < cycles; ++i) {
      steps.advance([&](const CycleRecord& record, bool) { stepped.observe(record); });
    }
  };
  go_on(6);
  steps.force(component, broken);
  go_on(1);
  EXPECT_EQ(stepped.seen.back().truth, Modes{broken});
  steps.command({cmd, turn_off});
  go_on(1);
  EXPECT_EQ(stepped.seen.back().truth, Modes{off});
  steps.observe({temp, high}, Ticks::of_seconds(1));
  go_on(32);
  Scenario scenario = steps.scenario();
  run_scenario(document, scenario, {}, {&flown});
  flown.seen.erase(flown.seen.begin());  // the start
  EXPECT_EQ(flown.seen, stepped.seen);
  EXPECT_EQ(flown.seen.size(), 40U);
  EXPECT_FALSE(steps.advance(nullptr));  // the duration is over
}

TEST(FlightSteps, WhatIsWaitedForIsFoundAgainAfterGoingBack) {
  const Document document = heater::document(true);
  FlightSteps steps(document, heater::scenario(), {});
  Watch watch(steps, is(mode, ValueId(on.index())), true);
  const auto run = [&] {
    bool holds = false;
    while (!holds && steps.advance([&](const CycleRecord& r, bool ended) { holds = watch.holds(r, ended); })) {
    }
    return holds ? steps.time() : Ticks::infinite();
  };
  EXPECT_EQ(run(), (Ticks{2'500'000'000}));
  steps.go_back_to(1);
  EXPECT_EQ(run(), (Ticks{2'500'000'000}));
}

TEST(ScenarioText, HasAllThatWasChosen) {
  const Document document = heater::document();
  Scenario base = heater::scenario();
  base.rules.push_back({Rule::Stream::command, is(cmd, turn_on), 3, {}, {temp, high}, Ticks::of_seconds(5), {}});
  Expectation expected = heater::expects(Expectation::Kind::never);
  expected.text = "never heater = broken";
  base.expectations = {expected};
  FlightSteps steps(document, base, {});
  steps.command({cmd, turn_off});
  steps.advance(nullptr);
  steps.force(component, broken);
  steps.observe({temp, low}, Ticks::infinite());
  EXPECT_EQ(scenario_text(steps.scenario(), steps.plant(), {"p.rmpl", "P", "h.tcca", ""}), R"(scenario "warm up" {
  program "p.rmpl" main P;
  plant "h.tcca";
  cycle 0.5 s;
  duration 20 s;
  seed 0;

  at 0 s command heater.cmd = off;
  at 1 s observe heater.temp = low;
  at 1 s fault heater = broken;

  when command heater.cmd = on after 3 cycles observe heater.temp = high for 5 s;

  expect never heater = broken;
}
)");
}

}  // namespace
}  // namespace rmpl::runtime
