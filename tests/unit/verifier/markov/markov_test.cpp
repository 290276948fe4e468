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
  static constexpr ComponentId pump{std::size_t{0}};
  static constexpr ComponentId valve{std::size_t{1}};
};

TEST_F(MarkovPump, ClassesOfWhatIsEnabledExcludeEachOther) {
  automata::PlantStep step(b_.plant);
  const Limits limits;
  Meter meter(limits);
  const auto open = enabled_classes(step, valve, ModeId(0), {ValueId(1)}, {pump}, meter);
  ASSERT_EQ(open.size(), 2U);
  EXPECT_EQ(open[0].enabled.untimed, (std::vector<TransitionId>{TransitionId(0)}));
  EXPECT_EQ(open[0].where, b_.is("pump", "runs"));
  EXPECT_TRUE(open[1].enabled.untimed.empty());
  EXPECT_EQ(open[1].where, b_.is("pump", "stands"));
  const auto idle = enabled_classes(step, valve, ModeId(0), {ValueId(0)}, {pump}, meter);
  ASSERT_EQ(idle.size(), 1U);
  EXPECT_EQ(idle[0].where, automata::constant(true));
}

TEST_F(MarkovPump, AFormulaHoldsSomewhereEverywhereOrNowhere) {
  automata::PlantStep step(b_.plant);
  const Limits limits;
  Meter meter(limits);
  EXPECT_EQ(where_holds(step, b_.is("pump", "stands"), true, {pump}, meter), b_.is("pump", "stands"));
  EXPECT_EQ(where_holds(step, automata::constant(true), true, {pump}, meter), automata::constant(true));
  EXPECT_EQ(where_holds(step, automata::constant(false), true, {pump}, meter), automata::constant(false));
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
  const auto classes = enabled_classes(step, component, heating, {ValueId(0)}, {}, meter);
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
