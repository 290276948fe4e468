// Durations are read and written without loss.
// SPDX-License-Identifier: MIT
#include "automata/time/time.hpp"

#include <gtest/gtest.h>

namespace rmpl::automata {
namespace {

TEST(Time, ReadsEveryUnit) {
  EXPECT_EQ(parse_duration("30"), Ticks::of_seconds(30));
  EXPECT_EQ(parse_duration("30 s"), Ticks::of_seconds(30));
  EXPECT_EQ(parse_duration("0.5h"), Ticks::of_seconds(1800));
  EXPECT_EQ(parse_duration("270 min"), Ticks::of_seconds(16200));
  EXPECT_EQ(parse_duration("4 mins"), Ticks::of_seconds(240));
  EXPECT_EQ(parse_duration("2 d"), Ticks::of_seconds(172800));
  EXPECT_EQ(parse_duration("5us"), (Ticks{5000}));
  EXPECT_EQ(parse_duration("7 ns"), (Ticks{7}));
  EXPECT_EQ(parse_duration("2 w"), Ticks::of_seconds(1209600));
  EXPECT_EQ(parse_duration("0.5 weeks"), Ticks::of_seconds(302400));
  EXPECT_EQ(parse_duration("1e-3"), (Ticks{1000000}));
  EXPECT_EQ(parse_duration("1.5e+2 ms"), (Ticks{150000000}));
  EXPECT_EQ(parse_duration("inf"), Ticks::infinite());
  EXPECT_EQ(parse_duration("∞"), Ticks::infinite());
}

TEST(Time, IsExactWhereADoubleIsNot) {
  EXPECT_EQ(parse_duration("43.8"), (Ticks{43'800'000'000}));
  EXPECT_EQ(*parse_duration("44.2") - *parse_duration("43.8"), *parse_duration("0.4"));
}

TEST(Time, ReadsAsManyDigitsAsATickNeeds) {
  EXPECT_EQ(parse_duration("98765.4321098765453125 d"), (Ticks{8'533'333'334'293'333'515}));
}

TEST(Time, RefusesWhatIsNoDuration) {
  for (const char* text : {"",
                           "s",
                           "-1",
                           "1.",
                           ".5",
                           "1 parsec",
                           "1e",
                           "0.1e-9",
                           "1e30",
                           "1e999999999999",
                           "nan",
                           "0x10",
                           "1 2",
                           "99999999999999999999",
                           "0.5 ns",
                           "1 year",
                           "1 week",
                           "1e+-3",
                           "0.5e-9223372036854775808",
                           "1000000000000000000000000 d"}) {
    EXPECT_FALSE(parse_duration(text)) << text;
  }
}

TEST(Time, WritesTheShortestDecimal) {
  EXPECT_EQ(format_seconds({43'200'000'000}), "43.2");
  EXPECT_EQ(format_seconds(Ticks::of_seconds(16200)), "16200");
  EXPECT_EQ(format_seconds({1}), "0.000000001");
  EXPECT_EQ(format_seconds({-500'000'000}), "-0.5");
  EXPECT_EQ(format_seconds({0}), "0");
  EXPECT_EQ(format_seconds(Ticks::infinite()), "inf");
}

}  // namespace
}  // namespace rmpl::automata
