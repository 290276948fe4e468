// What clocks that run beside each other can read at once.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/clock_order.hpp"

#include <gtest/gtest.h>

namespace rmpl::compiler {
namespace {

using automata::ClockId;
using automata::Formula;
using automata::Ticks;

constexpr Ticks tick{1};

/// Two clocks: the first is compared with 5 s and 10 s, the second with 7 s.
class Order : public ::testing::Test {
 protected:
  static Formula at_least(std::size_t clock, int seconds) {
    Formula formula;
    formula.kind = Formula::Kind::clock;
    formula.clock = ClockId(clock);
    formula.bound = Ticks::of_seconds(seconds);
    return formula;
  }
  std::vector<Ticks> least(RunningClock first, RunningClock second) const {
    std::vector<RunningClock> clocks{first, second};
    return order_.least(clocks);
  }

  std::vector<Formula> formulas_{at_least(0, 5), at_least(0, 10), at_least(1, 7)};
  ClockOrder order_{{&formulas_[0], &formulas_[1], &formulas_[2]}};
  ClockId a_{0}, b_{1};
};

TEST_F(Order, ClocksThatWereStartedTogetherReadTheSame) {
  const auto at = [](int seconds) { return Ticks::of_seconds(seconds); };
  EXPECT_TRUE(least({a_, 0, at(5), false}, {b_, 0, at(7), false}).empty());
  EXPECT_TRUE(least({a_, 0, at(5), false}, {b_, 0, at(8), false}).empty());
  EXPECT_EQ(least({a_, 0, at(8), false}, {b_, 0, at(7), false}), (std::vector{at(7), at(7)}));
  EXPECT_EQ(least({a_, 0, at(6), false}, {b_, 0, at(8), false}), (std::vector{at(7) + tick, at(7) + tick}));
  EXPECT_EQ(least({a_, 0, at(10), true}, {b_, 0, at(8), false}), (std::vector{at(10), at(10)}));
}

TEST_F(Order, ThoseThatWereStartedEarlierReadMore) {
  const auto at = [](int seconds) { return Ticks::of_seconds(seconds); };
  EXPECT_TRUE(least({a_, 0, at(5), false}, {b_, 1, at(7), false}).empty());
  EXPECT_EQ(least({a_, 0, at(6), false}, {b_, 1, at(7), false}), (std::vector{at(7), at(7) + tick}));
  EXPECT_EQ(least({a_, 0, at(5), false}, {b_, 1, at(3), false}), (std::vector{tick, at(5)}));
  EXPECT_EQ(least({a_, 1, at(5), false}, {b_, 0, at(3), true}), (std::vector{at(5), at(5) + tick}));
}

}  // namespace
}  // namespace rmpl::compiler
