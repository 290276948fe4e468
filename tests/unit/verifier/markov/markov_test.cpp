// What a component draws from, by modes and readings of its clock.
// SPDX-License-Identifier: MIT
#include "verifier/markov/markov.hpp"

#include <gtest/gtest.h>

#include "tests/unit/verifier/plants.hpp"

namespace rmpl::verifier {
namespace {

using automata::ComponentId;
using automata::ModeId;
using automata::TransitionId;
using automata::ValueId;
using test::seconds;

TEST(ModeCases, NameOnlyWhatDecides) {
  ModeCases cases({ComponentId(3), ComponentId(5)});
  for (std::size_t a = 0; a < 2; ++a) {
    for (std::size_t b = 0; b < 2; ++b) cases.add({ModeId(a), ModeId(b)}, b);
  }
  EXPECT_EQ(cases.conditions(),
            (std::vector<Condition>{{{{ComponentId(5), ModeId(0)}}}, {{{ComponentId(5), ModeId(1)}}}}));
}

TEST(ModeCases, OneNumberIsEverywhereAndNoneIsNowhere) {
  ModeCases same({ComponentId(0)});
  same.add({ModeId(0)}, 1);
  same.add({ModeId(1)}, 1);
  EXPECT_EQ(same.conditions(), (std::vector<Condition>{{}, {{}}}));
  EXPECT_TRUE(ModeCases({ComponentId(0)}).conditions().empty());
}

/// A valve that opens under a command while the pump runs.
class MarkovPump : public testing::Test {
 protected:
  MarkovPump() {
    b_.control("cmd", {"none", "open"});
    b_.component("pump", {"runs", "stands"});
    auto& shuts = b_.component("valve", {"shut", "wide", "stuck!"});
    b_.transition(shuts, 0, 1, automata::conjunction({b_.is("cmd", "open"), b_.is("pump", "runs")}));
    b_.transition(shuts, 0, 2, automata::constant(true), {}, test::probability(0.25));
  }
  test::PlantBuilder b_;
  static constexpr ComponentId valve{std::size_t{1}};
};

TEST_F(MarkovPump, ClassesOfWhatIsEnabledExcludeEachOther) {
  automata::PlantStep step(b_.plant);
  const Limits limits;
  Meter meter(limits);
  const auto open = enabled_classes(step, valve, ModeId(0), {ValueId(1)}, meter);
  ASSERT_EQ(open.size(), 2U);
  EXPECT_EQ(open[0].enabled.untimed, (std::vector<TransitionId>{TransitionId(0)}));
  EXPECT_EQ(open[0].where, (Condition{{{ComponentId(0), ModeId(0)}}}));
  EXPECT_TRUE(open[1].enabled.untimed.empty());
  EXPECT_EQ(open[1].where, (Condition{{{ComponentId(0), ModeId(1)}}}));
  const auto idle = enabled_classes(step, valve, ModeId(0), {ValueId(0)}, meter);
  ASSERT_EQ(idle.size(), 1U);
  EXPECT_EQ(idle[0].where, (Condition{{}}));
}

TEST_F(MarkovPump, AFormulaHoldsSomewhereEverywhereOrNowhere) {
  automata::PlantStep step(b_.plant);
  const Limits limits;
  Meter meter(limits);
  EXPECT_EQ(where_holds(step, b_.is("pump", "stands"), true, meter), (Condition{{{ComponentId(0), ModeId(1)}}}));
  EXPECT_EQ(where_holds(step, automata::constant(true), true, meter), (Condition{{}}));
  EXPECT_TRUE(where_holds(step, automata::constant(false), true, meter).empty());
}

TEST(MarkovEngine, DrawsTheSameOverStretchesOfReadings) {
  const test::PlantBuilder engine = test::engine();
  automata::PlantStep step(engine.plant);
  const Limits limits;
  Meter meter(limits);
  const ComponentId component(std::size_t{0});
  const ModeId heating(1);
  const auto settled = settled_reading(engine.plant.components[0], heating, seconds(10));
  ASSERT_EQ(settled, 6);
  const auto classes = enabled_classes(step, component, heating, {ValueId(0)}, meter);
  ASSERT_EQ(classes.size(), 1U);
  const auto drawn = stretches(step, component, heating, classes[0].enabled, seconds(10), *settled);
  // Up to 30 s it heats; then the hazard of a uniform density grows, until it is ready for certain.
  ASSERT_EQ(drawn.size(), 4U);
  EXPECT_EQ(drawn[0].first, 0);
  EXPECT_EQ(drawn[0].last, 2);
  EXPECT_EQ(drawn[0].moves.size(), 2U);
  EXPECT_EQ(drawn[1].moves.size(), 3U);
  EXPECT_EQ(drawn[3].first, 5);
  EXPECT_EQ(drawn[3].last, std::nullopt);
  EXPECT_EQ(drawn[3].moves.size(), 2U);
}

}  // namespace
}  // namespace rmpl::verifier
