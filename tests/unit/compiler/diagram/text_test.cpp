// Where lines are broken, and how numbers are written.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "compiler/diagram/numbers.hpp"
#include "compiler/diagram/style.hpp"

namespace rmpl::compiler {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Lines, AreBrokenBehindConnectives) {
  EXPECT_THAT(style::wrapped("a = b & c = d | e = f", 10), ElementsAre("a = b &", "c = d |", "e = f"));
  EXPECT_THAT(style::wrapped("a = b & c = d | e = f", 16), ElementsAre("a = b & c = d |", "e = f"));
  EXPECT_THAT(style::wrapped("a = b", 2), ElementsAre("a = b"));
  EXPECT_THAT(style::wrapped("", 10), IsEmpty());
}

TEST(Lines, BreakListsOnlyWhereTheyAreLong) {
  EXPECT_THAT(style::wrapped("a = b & temp in {cold, nominal}", 30), ElementsAre("a = b &", "temp in {cold, nominal}"));
  EXPECT_THAT(style::wrapped("temp in {frozen, cold, nominal}", 20), ElementsAre("temp in {frozen,", "cold, nominal}"));
}

TEST(Names, AreBrokenBehindSeparators) {
  EXPECT_THAT(style::broken_name("spacecraft_deployment =", 14), ElementsAre("spacecraft_", "deployment ="));
  EXPECT_THAT(style::broken_name("mes.engine_a.engine", 14), ElementsAre("mes.engine_a.", "engine"));
  EXPECT_THAT(style::broken_name("unbreakablename", 4), ElementsAre("unbreakablename"));
  EXPECT_THAT(style::broken_name("on", 14), ElementsAre("on"));
}

automata::Weight rate(double per_second) { return {automata::Weight::Kind::rate, per_second}; }

TEST(Numbers, AreShort) {
  EXPECT_EQ(shortest(0.001), "0.001");
  EXPECT_EQ(shortest(1e-6), "1e-6");
  EXPECT_EQ(shortest(1e100), "1e100");
  EXPECT_EQ(shortest(-20), "-20");
}

TEST(Numbers, GiveRatesInTheirShortestUnit) {
  EXPECT_EQ(to_text(rate(1e-4 / 3600)), "with rate 0.0001 /h");
  EXPECT_EQ(to_text(rate(2)), "with rate 2 /s");
  EXPECT_EQ(to_text(rate(7e-9 / 86400)), "with rate 7e-9 /d");
  EXPECT_EQ(to_text(automata::Weight{automata::Weight::Kind::probability, 0.01}), "with 0.01");
  EXPECT_EQ(to_text(automata::Weight{}), "");
}

TEST(Numbers, GiveBoundsAndDensities) {
  using automata::Density;
  using automata::Ticks;
  const auto seconds = [](std::int64_t count) { return Ticks::of_seconds(count); };
  EXPECT_EQ(to_text(automata::Timing{seconds(30), seconds(60), {}}), "in [30 s, 60 s]");
  EXPECT_EQ(to_text(automata::Timing{seconds(5), seconds(5), {}}), "after 5 s");
  EXPECT_EQ(to_text(automata::Timing{seconds(0), Ticks::infinite(), {Density::Kind::exponential, 3600, 0}}),
            "in [0 s, inf] ~ exponential(3600 s)");
  EXPECT_EQ(to_text(automata::Timing{seconds(1), Ticks::infinite(), {Density::Kind::normal, 20, 0.5}}),
            "in [1 s, inf] ~ normal(20 s, 0.5 s)");
  EXPECT_EQ(to_text(automata::Timing{seconds(0), seconds(9), {Density::Kind::weibull, 0, 0, 1.5, 60}}),
            "in [0 s, 9 s] ~ weibull(1.5, 60 s)");
  EXPECT_EQ(to_text(automata::Timing{seconds(0), Ticks::infinite(), {Density::Kind::erlang, 60, 0, 3}}),
            "in [0 s, inf] ~ erlang(3, 60 s)");
}

}  // namespace
}  // namespace rmpl::compiler
