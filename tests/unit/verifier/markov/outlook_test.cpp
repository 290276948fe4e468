// What may still come of a state of a closed loop.
// SPDX-License-Identifier: MIT
#include "verifier/markov/outlook.hpp"

#include <gtest/gtest.h>

#include "tests/unit/verifier/plants.hpp"

namespace rmpl::verifier {
namespace {

using automata::Formula;
using automata::LocationId;
using automata::Marking;
using automata::ModeId;
using automata::Modes;
using test::seconds;

/// A lamp that time may break, a bolt that is fired once, and a radio that time may break, each by itself. The program
/// asks for the bolt, then for the lamp, and ends.
class OutlookOnALamp : public testing::Test {
 protected:
  OutlookOnALamp() {
    b_.control("switch", {"none", "on"});
    b_.control("fire", {"none", "now"});
    auto& lamp = b_.component("lamp", {"dark", "lit", "broken!"});
    b_.transition(lamp, 0, 1, b_.is("switch", "on"));
    for (const std::size_t mode : {0U, 1U})
      b_.transition(lamp, mode, 2, automata::constant(true), {}, test::rate(1e-6));
    auto& bolt = b_.component("bolt", {"holds", "gone", "stuck!"});
    b_.transition(bolt, 0, 1, b_.is("fire", "now"));
    b_.transition(bolt, 0, 2, b_.is("fire", "now"), {}, test::probability(0.01));
    auto& radio = b_.component("radio", {"works", "silent!"});
    b_.transition(radio, 0, 1, automata::constant(true), {}, test::rate(1e-6));

    program_.name = "Light";
    program_.variables = b_.plant.variables;
    program_.locations.resize(3);
    program_.locations[0].composite = true;
    program_.locations[1].start = true;
    for (const std::size_t l : {1U, 2U}) program_.locations[l].parent = LocationId(0);
    program_.locations[1].goal = {{b_.plant.components[1].mode, automata::ValueId(1)}};
    program_.locations[1].arcs = {{{}, LocationId(2)}};
    program_.locations[2].goal = {{b_.plant.components[0].mode, automata::ValueId(1)}};
  }

  Outlook::Told ask(const Formula& target, const Marking& marking, const Modes& modes) {
    const Limits limits;
    Meter meter(limits);
    return Outlook(program_, b_.plant, {target, false, seconds(1), 1e-6L}, meter).tell(marking, modes);
  }

  test::PlantBuilder b_;
  automata::Program program_;
  const Marking first_{LocationId(0), LocationId(1)}, second_{LocationId(0), LocationId(2)};
  const Modes start_{ModeId(0), ModeId(0), ModeId(0)};
};

TEST_F(OutlookOnALamp, AGoalThatCannotBeHadLeavesTheHazardOfRest) {
  const auto told = ask(b_.is("lamp", "broken"), first_, {ModeId(0), ModeId(2), ModeId(0)});
  ASSERT_TRUE(told.steady_hazard.has_value());
  EXPECT_NEAR(static_cast<double>(told.steady_hazard->upper), 1e-6, 1e-11);
  EXPECT_LE(told.steady_hazard->lower, told.steady_hazard->upper);
}

TEST_F(OutlookOnALamp, AProgramThatMayEndHasNoSteadyHazard) {
  EXPECT_FALSE(ask(b_.is("lamp", "broken"), first_, start_).steady_hazard.has_value());
  EXPECT_FALSE(ask(b_.is("lamp", "broken"), second_, start_).steady_hazard.has_value());
}

TEST_F(OutlookOnALamp, ATargetOutOfReachHasNone) {
  const auto told = ask(b_.is("bolt", "stuck"), second_, {ModeId(0), ModeId(1), ModeId(0)});
  ASSERT_TRUE(told.steady_hazard.has_value());
  EXPECT_EQ(told.steady_hazard->upper, 0);
}

TEST_F(OutlookOnALamp, ATargetThatHoldsIsToldNothingOf) {
  const auto told = ask(b_.is("bolt", "stuck"), first_, {ModeId(0), ModeId(2), ModeId(0)});
  EXPECT_FALSE(told.steady_hazard.has_value());
  EXPECT_TRUE(told.idle.empty());
}

TEST_F(OutlookOnALamp, WhatNobodyAsksForIsIdle) {
  const auto told = ask(b_.is("lamp", "broken"), first_, start_);
  EXPECT_EQ(told.idle, (std::vector<bool>{false, false, true}));
  EXPECT_EQ(told.modes, (Modes{ModeId(0), ModeId(0), ModeId(1)}));
  const auto later = ask(b_.is("lamp", "broken"), second_, {ModeId(0), ModeId(1), ModeId(0)});
  EXPECT_EQ(later.idle, (std::vector<bool>{false, true, true}));
  EXPECT_EQ(later.modes, (Modes{ModeId(0), ModeId(1), ModeId(1)}));
}

TEST_F(OutlookOnALamp, AConditionThatMayTurnOutEitherWayMatters) {
  program_.locations[2].arcs = {{{true, b_.is("radio", "works")}, LocationId(2)}};
  EXPECT_EQ(ask(b_.is("lamp", "broken"), first_, start_).idle, std::vector<bool>{});
  // Once it is silent it stays so.
  const auto silent = ask(b_.is("lamp", "broken"), first_, {ModeId(0), ModeId(0), ModeId(1)});
  EXPECT_EQ(silent.idle, (std::vector<bool>{false, false, true}));
}

}  // namespace
}  // namespace rmpl::verifier
