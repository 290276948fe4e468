// Times of logs: what their texts say, where they count from, which samples are odd.
// SPDX-License-Identifier: MIT
#include "runtime/telemetry/log_times.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rmpl::runtime {
namespace {

using Kind = TimeText::Kind;

constexpr WideNanoseconds second = 1'000'000'000;

TEST(TimeText, RoundsToTheNearestNanosecond) {
  const std::vector<std::pair<std::string, WideNanoseconds>> table{
      {"0.30000000000000004", 300'000'000},
      {"0.6000000000000001", 600'000'000},
      {"0.0000000004", 0},
      {"0.0000000005", 1},
      {"-0.0000000005", -1},
      {"1e-10", 0},
      {"1e-400", 0},
      {"9007199.254740993", 9'007'199'254'740'993},
      {"1.7e9", 1'700'000'000 * second},
      {"000012.50", 12'500'000'000},
      {"0.99999999999999999999999999999999999999999", second},
      {"1700000000123.456789012345678", WideNanoseconds{1'700'000'000'123} * second + 456'789'012}};
  for (const auto& [text, count] : table) EXPECT_EQ(read_time_text(text), (TimeText{Kind::number, count})) << text;
}

TEST(TimeText, ReadsDurationsMissionTimesAndDates) {
  EXPECT_EQ(read_time_text("270 min"), (TimeText{Kind::duration, 16'200 * second}));
  EXPECT_EQ(read_time_text("0.30000000000000004 ms"), (TimeText{Kind::duration, 300'000}));
  EXPECT_EQ(read_time_text("T+4:34:45.5"), (TimeText{Kind::mission, 16'485'500'000'000}));
  EXPECT_EQ(read_time_text("MET 3/04:05:06"), (TimeText{Kind::mission, ((3 * 24 + 4) * 3600 + 5 * 60 + 6) * second}));
  EXPECT_EQ(read_time_text("003:04:05:06"), read_time_text("3/04:05:06"));
  EXPECT_EQ(read_time_text("T-00:10"), (TimeText{Kind::mission, -600 * second}));
  const TimeText date{Kind::date, 1'700'000'000 * second};
  for (const char* text : {"2023-11-14T22:13:20Z", "2023-11-14 22:13:20", "2023-318T22:13:20z",
                           "2023-11-15T00:13:20+02:00", "2023-11-14T17:13:20-0500", "2023-11-14T23:13:20+01"}) {
    EXPECT_EQ(read_time_text(text), date) << text;
  }
  EXPECT_EQ(read_time_text("1969-12-31T23:59:59.5Z"), (TimeText{Kind::date, -second / 2}));
  EXPECT_EQ(read_time_text("2023-11-14"), (TimeText{Kind::date, 1'699'920'000 * second}));
  EXPECT_EQ(format_date(date.count), "2023-11-14T22:13:20Z");
}

TEST(TimeText, RefusesWhatIsNoTime) {
  for (const char* text : {"", " ", "nan", "inf", "1 month", "2023-13-01", "2023-02-29", "2023-366", "2023-11-14T25:00",
                           "12:60", "1:2:3:4:5", "1e99", "1e9999", "--1", "1.", "0x10", "2023-11-14T22:13:20Q",
                           "10000000000000000000000000000000000000000000000000000000000000000000000000000000 w"}) {
    EXPECT_EQ(read_time_text(text), std::nullopt) << text;
  }
}

/// The fates of samples at these times, in a row.
std::vector<TimeFate> fates(LogTimes& times, const std::vector<std::string>& texts) {
  std::vector<TimeFate> result;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const auto peek = [&] { return i + 1 < texts.size() ? read_time_text(texts[i + 1]) : std::nullopt; };
    const auto place = times.place(*read_time_text(texts[i]), peek);
    result.push_back(place ? place->fate : TimeFate::repeated);
  }
  return result;
}

constexpr TimeFate follows = TimeFate::follows, late = TimeFate::out_of_order, unit = TimeFate::wrong_unit,
                   before = TimeFate::before_origin;

TEST(LogTimes, CountFromTheOriginThatIsNamed) {
  const auto none = [] { return std::optional<TimeText>(); };
  LogTimes first({.from_first = true, .origin = {}});
  EXPECT_EQ(first.place(*read_time_text("1700000000"), none)->time.count, 0);
  EXPECT_EQ(first.place(*read_time_text("1700000001.5"), none)->time.count, 1'500'000'000);
  EXPECT_TRUE(first.take_remarks().empty());
  LogTimes dated({.origin = read_time_text("2023-11-14T22:13:20Z")});
  EXPECT_EQ(dated.place(*read_time_text("1700000001"), none)->time.count, second);
  EXPECT_EQ(dated.place(*read_time_text("1699999999"), none)->fate, before);
  LogTimes milliseconds({.origin = read_time_text("1700000000")});
  EXPECT_EQ(milliseconds.place(*read_time_text("1700000000250"), none)->time.count, 250'000'000);
  LogTimes named({.origin = {}, .unit = 1'000'000});
  EXPECT_EQ(named.place(*read_time_text("250"), none)->time.count, 250'000'000);
}

TEST(LogTimes, WarnOfAFirstStepOfMoreThanADay) {
  const auto none = [] { return std::optional<TimeText>(); };
  LogTimes times;
  times.place(*read_time_text("0"), none);
  EXPECT_TRUE(times.take_remarks().empty());
  times.place(*read_time_text("1700000000"), none);
  const auto remarks = times.take_remarks();
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].find("--origin first"), std::string::npos);
  LogTimes dates;
  EXPECT_EQ(dates.place(*read_time_text("2023-11-14T22:13:20Z"), none)->time.count, 0);
  EXPECT_EQ(dates.take_remarks().size(), 1U);
  LogTimes whole_day;
  whole_day.place(*read_time_text("86400"), none);
  EXPECT_TRUE(whole_day.take_remarks().empty());
}

TEST(LogTimes, TellOddSamplesApart) {
  LogTimes times;
  EXPECT_EQ(fates(times, {"1", "2", "1.5", "2", "3"}), (std::vector{follows, follows, late, follows, follows}));
  LogTimes units;
  EXPECT_EQ(fates(units, {"1", "2", "3000", "4", "5"}), (std::vector{follows, follows, unit, follows, follows}));
  LogTimes gap;  // nothing goes back behind it
  EXPECT_EQ(fates(gap, {"1", "2", "3600", "3601"}), (std::vector{follows, follows, follows, follows}));
  LogTimes unix_times;
  EXPECT_EQ(fates(unix_times, {"1700000000", "1700000001000", "1700000002"}), (std::vector{follows, unit, follows}));
  LogTimes counted;
  counted.leave_out(late, 7);
  counted.leave_out(late, 9);
  counted.leave_out(unit, 8);
  EXPECT_EQ(counted.left_out(),
            (std::vector<std::string>{"2 samples out of order were left out, the first in line 7",
                                      "1 sample in the wrong unit of time was left out, in line 8"}));
}

}  // namespace
}  // namespace rmpl::runtime
