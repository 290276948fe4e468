// What replay lets pass, and what it does not.
// SPDX-License-Identifier: MIT
#include "verifier/witness/replay.hpp"

#include <gtest/gtest.h>

#include "tests/unit/verifier/plants.hpp"
#include "verifier/zone/schedule.hpp"

namespace rmpl::verifier {
namespace {

using automata::ModeId;
using automata::Ticks;
using automata::ValueId;
using test::seconds;

class ReplayEngine : public testing::Test {
 protected:
  /// off at 0, heating at `heats`, standby at `ready`.
  [[nodiscard]] static Witness run(Ticks heats, Ticks ready) {
    return {
        {{Ticks{0}, {ModeId(0)}, {ValueId(0)}}, {heats, {ModeId(1)}, {ValueId(1)}}, {ready, {ModeId(2)}, {ValueId(0)}}},
        std::nullopt,
        std::nullopt};
  }
  std::optional<std::string> failure(const Witness& witness, const ReplayRules& rules) {
    return replay(rules_, witness, rules);
  }

  test::PlantBuilder engine_ = test::engine();
  automata::PlainStep rules_{engine_.plant};
};

TEST_F(ReplayEngine, DenseBoundsAreClosed) {
  EXPECT_EQ(failure(run(seconds(5), seconds(35)), {}), std::nullopt);
  EXPECT_EQ(failure(run(seconds(5), seconds(65)), {}), std::nullopt);
  EXPECT_TRUE(failure(run(seconds(5), seconds(35) - Ticks{1}), {}));
  EXPECT_TRUE(failure(run(seconds(5), seconds(65) + Ticks{1}), {}));
}

TEST_F(ReplayEngine, SampledStepsNeedAPositiveProbability) {
  const ReplayRules rules{seconds(1), Commands::one, 0, {}};
  EXPECT_TRUE(failure(run(seconds(5), seconds(35)), rules));
  EXPECT_EQ(failure(run(seconds(5), seconds(36)), rules), std::nullopt);
  EXPECT_EQ(failure(run(seconds(5), seconds(65)), rules), std::nullopt);
  EXPECT_TRUE(failure(run(seconds(5), seconds(66)), rules));
  EXPECT_TRUE(failure(run(Ticks{500'000'000}, seconds(36)), rules));
}

TEST_F(ReplayEngine, CommandsAndFaultsAreCounted) {
  EXPECT_TRUE(failure(run(seconds(5), seconds(35)), {std::nullopt, Commands::none, 0, {}}));
  const Witness broken{
      {{Ticks{0}, {ModeId(0)}, {ValueId(0)}}, {Ticks{0}, {ModeId(4)}, {ValueId(0)}}}, std::nullopt, std::nullopt};
  EXPECT_TRUE(failure(broken, {}));
  EXPECT_EQ(failure(broken, {std::nullopt, Commands::none, 1, {}}), std::nullopt);
}

TEST_F(ReplayEngine, WhatIsFalsifiedIsRefused) {
  const Witness right = run(seconds(5), seconds(35));
  ASSERT_EQ(failure(right, {}), std::nullopt);
  Witness other_time = right;
  other_time.events[2].time = seconds(4);
  EXPECT_EQ(failure(other_time, {}), "time runs backwards at 4 s");
  Witness other_mode = right;
  other_mode.events[2].modes = {ModeId(3)};
  EXPECT_EQ(failure(other_mode, {}), "the step is not possible at 35 s");
  Witness other_command = right;
  other_command.events[1].action = {ValueId(3)};
  EXPECT_EQ(failure(other_command, {}), "the step is not possible at 5 s");
}

TEST_F(ReplayEngine, TheStartIsAnInitialState) {
  const Witness standby{{{Ticks{0}, {ModeId(2)}, {ValueId(0)}}}, std::nullopt, std::nullopt};
  EXPECT_TRUE(failure(standby, {}));
  const ReplayRules from{std::nullopt, Commands::one, 0, {{engine_.plant.components[0].mode, ValueId(2)}}};
  EXPECT_EQ(failure(standby, from), std::nullopt);
  EXPECT_TRUE(failure({}, {}));
}

TEST(Schedule, FindsTheEarliestTimesOrNone) {
  Schedule schedule;
  const auto a = schedule.add_point();
  const auto b = schedule.add_point();
  schedule.constrain(0, a, {2, 9});
  schedule.constrain(a, b, {3, unbounded});
  schedule.constrain(0, b, {7, 7});
  EXPECT_EQ(schedule.solve(), (std::vector<Units>{0, 2, 7}));
  schedule.constrain(a, b, {0, 4});
  EXPECT_EQ(schedule.solve(), (std::vector<Units>{0, 3, 7}));
  schedule.constrain(0, a, {0, 2});
  EXPECT_EQ(schedule.solve(), std::nullopt);
}

}  // namespace
}  // namespace rmpl::verifier
