// Choices and waits of one component against the probabilities of the step function.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/choices.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/verifier/plants.hpp"

namespace rmpl::verifier {
namespace {

using automata::ModeId;
using automata::Ticks;
using test::PlantBuilder;
using test::seconds;
using test::within;

/// A component whose exits compete, among them one without an upper bound and one of length 0, and whose faults come
/// and go until, from 6 s to 8 s, one is certain.
PlantBuilder contested() {
  PlantBuilder b;
  auto& c = b.component("c", {"start", "early", "late", "point", "failed!", "lost!"});
  PlantBuilder::transition(c, 0, 1, automata::constant(true), within(2, 10));
  PlantBuilder::transition(
      c, 0, 2, automata::constant(true),
      automata::Timing{seconds(4), Ticks::infinite(), {automata::Density::Kind::exponential, 5, 0}});
  PlantBuilder::transition(c, 0, 3, automata::constant(true), within(11, 11));
  PlantBuilder::transition(c, 0, 4, automata::constant(true), within(1, 8), test::probability(0.5));
  PlantBuilder::transition(c, 0, 5, automata::constant(true), within(6, 12), test::probability(0.5));
  return b;
}

std::vector<ModeId> chosen(const std::vector<Choice>& all, Units clock) {
  std::vector<ModeId> modes;
  for (const Choice& choice : all) {
    if (choice.clock.contains(clock)) modes.push_back(choice.mode);
  }
  std::sort(modes.begin(), modes.end());
  modes.erase(std::unique(modes.begin(), modes.end()), modes.end());
  return modes;
}

TEST(Choices, SampledOnesAreThoseOfPositiveProbability) {
  const PlantBuilder b = contested();
  automata::PlantStep step(b.plant);
  const auto enabled = step.enabled({ModeId(0)}, {}).front();
  for (const Ticks period : {seconds(1), seconds(3), Ticks{700'000'000}, seconds(20)}) {
    const TimeModel time = TimeModel::sampled(period);
    const auto all = choices(b.plant.components[0], ModeId(0), enabled, time);
    for (Units clock = 1; clock < 40; ++clock) {
      std::vector<ModeId> possible;
      const Ticks now = time.ticks(clock);
      for (const auto& move : step.moves(automata::ComponentId(0), ModeId(0), enabled, Ticks{0}, now - period, now)) {
        possible.push_back(move.mode);
      }
      EXPECT_EQ(chosen(all, clock), possible) << clock << " periods of " << automata::format_seconds(period) << " s";
    }
  }
}

TEST(Choices, DenseOnesLeaveStayingOpenUpToTheBound) {
  const PlantBuilder b = contested();
  automata::PlantStep step(b.plant);
  const auto enabled = step.enabled({ModeId(0)}, {}).front();
  const TimeModel time = TimeModel::dense(b.plant, {});
  EXPECT_EQ(time.unit(), seconds(1));
  const auto all = choices(b.plant.components[0], ModeId(0), enabled, time);
  const auto modes = [](std::initializer_list<std::size_t> ids) { return std::vector<ModeId>(ids.begin(), ids.end()); };
  EXPECT_EQ(chosen(all, 0), modes({0}));
  EXPECT_EQ(chosen(all, 2), modes({0, 1, 4}));
  EXPECT_EQ(chosen(all, 7), modes({4, 5}));
  EXPECT_EQ(chosen(all, 10), modes({0, 1, 2, 5})) << "due, and yet to be seen waiting";
  EXPECT_EQ(chosen(all, 11), modes({1, 3, 5})) << "overdue: taken now";
  EXPECT_EQ(waits(b.plant.components[0], ModeId(0), enabled, time), (std::vector<Interval>{{0, 6}, {9, 10}}))
      << "no time passes while a fault is certain";
}

TEST(Waits, EndWhereStayingDoes) {
  const PlantBuilder b = contested();
  automata::PlantStep step(b.plant);
  const auto enabled = step.enabled({ModeId(0)}, {}).front();
  // Staying is possible in the periods that end at 1 … 5 s and at 9 s: not beside a certain fault or a certain exit.
  EXPECT_EQ(waits(b.plant.components[0], ModeId(0), enabled, TimeModel::sampled(seconds(1))),
            (std::vector<Interval>{{0, 5}, {8, 9}}));
}

TEST(TimeModel, RoundsOutwardsAndInwards) {
  const TimeModel time = TimeModel::sampled(seconds(2));
  EXPECT_EQ(time.at_least(seconds(5)), 3);
  EXPECT_EQ(time.at_most(seconds(5)), 2);
  EXPECT_EQ(time.more_than(seconds(4)), 3);
  EXPECT_EQ(time.at_least(Ticks::infinite()), unbounded);
}

}  // namespace
}  // namespace rmpl::verifier
