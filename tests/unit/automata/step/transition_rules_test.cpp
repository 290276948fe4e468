// What the faults of a component leave, and what is too improbable for a double.
// SPDX-License-Identifier: MIT
#include "automata/step/transition_rules.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace rmpl::automata {
namespace {

Ticks s(std::int64_t seconds) { return Ticks::of_seconds(seconds); }

/// A component in its first mode, with a second one and a fault mode.
class Rules : public testing::Test {
 protected:
  Rules() {
    component.modes.resize(3);
    component.modes[2].fault = true;
  }
  void add(std::size_t to, std::optional<Timing> timing, Weight weight) {
    component.transitions.push_back({ModeId(0u),
                                     ModeId(to),
                                     constant(true),
                                     timing,
                                     weight,
                                     static_cast<std::uint32_t>(component.transitions.size()),
                                     {}});
  }
  [[nodiscard]] Enabled all() const {
    return enabled_in(component, ModeId(0u), [](TransitionId) { return true; });
  }
  [[nodiscard]] std::vector<Move> moves(Ticks clock, Ticks step) const {
    return moves_of(component, ModeId(0u), all(), clock, step);
  }
  Component component;
};

TEST_F(Rules, ARateAloneAlwaysLeavesAShare) {
  add(2, std::nullopt, {Weight::Kind::rate, 1});
  EXPECT_NEAR(nominal_share(component, all(), s(60), s(60)) / std::exp(-60.0), 1, 1e-14);
  EXPECT_GT(nominal_share(component, all(), s(1'000'000), s(1'000'000)), 0);
  EXPECT_EQ(moves(s(1'000'000), s(1'000'000)).size(), 2u);
}

TEST_F(Rules, FaultsThatReachOneLeaveNothing) {
  add(2, std::nullopt, {Weight::Kind::probability, 1});
  EXPECT_EQ(nominal_share(component, all(), s(1), s(1)), 0);
  EXPECT_EQ(moves(s(1), s(1)).size(), 1u);
}

TEST_F(Rules, FaultsOfMoreThanOneShareTheStep) {
  add(2, std::nullopt, {Weight::Kind::probability, 0.9});
  add(1, std::nullopt, {Weight::Kind::rate, 1e6});
  component.modes[1].fault = true;
  const auto both = moves(s(1), s(1));
  ASSERT_EQ(both.size(), 2u);
  EXPECT_DOUBLE_EQ(both[0].probability, 1 / 1.9);
  EXPECT_DOUBLE_EQ(both[1].probability, 0.9 / 1.9);
}

TEST_F(Rules, WhatIsPossibleHasAProbability) {
  add(1, Timing{s(0), Ticks::infinite(), {Density::Kind::normal, 1e9, 1}}, {});
  const auto early = moves(s(1), s(1));  // a billion standard deviations before the mean
  ASSERT_EQ(early.size(), 2u);
  EXPECT_GT(early[1].probability, 0);
  EXPECT_EQ(early[0].probability, 1);
  EXPECT_TRUE(lead({early}, {ModeId(1u)}));
  EXPECT_FALSE(lead({early}, {ModeId(2u)}));
}

TEST_F(Rules, BesideWhatIsCertainNothingElseHappens) {
  add(1, Timing{s(0), s(10), {}}, {});
  add(0, Timing{s(5), s(6), {}}, {});
  const auto due = moves(s(7), s(1));
  ASSERT_EQ(due.size(), 1u);
  EXPECT_EQ(due[0].mode, ModeId(0u));
}

TEST_F(Rules, WithoutWeightThereIsNoExit) {
  add(1, std::nullopt, {Weight::Kind::probability, 0});
  EXPECT_TRUE(all().untimed.empty());
}

}  // namespace
}  // namespace rmpl::automata
