// Origins and units of times, and what is said of them.
// SPDX-License-Identifier: MIT
#include "runtime/telemetry/log_times.hpp"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

namespace rmpl::runtime {
namespace {

using Kind = TimeText::Kind;

constexpr WideNanoseconds second = automata::Ticks::per_second;
constexpr WideNanoseconds day = 86'400 * second;
constexpr std::array<std::int64_t, 3> smaller_units{1'000'000, 1'000, 1};  // ms, us, ns, in nanoseconds

/// In nanoseconds; by the size of a number, taken for seconds.
std::int64_t unit_by_size(WideNanoseconds count) {
  WideNanoseconds bound = 100'000'000'000 * second;
  std::int64_t unit = automata::Ticks::per_second;
  for (const std::int64_t smaller : smaller_units) {
    if ((count < 0 ? -count : count) < bound) break;
    unit = smaller;
    bound *= 1000;
  }
  return unit;
}

std::string_view name_of_unit(std::int64_t unit) {
  switch (unit) {
    case 1'000'000:
      return "milliseconds";
    case 1'000:
      return "microseconds";
    case 1:
      return "nanoseconds";
    default:
      return "seconds";
  }
}

WideNanoseconds scaled(WideNanoseconds count, std::int64_t unit) {
  const WideNanoseconds divisor = automata::Ticks::per_second / std::min(unit, automata::Ticks::per_second);
  const WideNanoseconds half = count < 0 ? -divisor / 2 : divisor / 2;
  return (count + half) / divisor * (unit / std::min(unit, automata::Ticks::per_second));
}

std::string_view what_is_odd(TimeFate fate) {
  switch (fate) {
    case TimeFate::follows:
      break;
    case TimeFate::out_of_order:
      return "out of order";
    case TimeFate::wrong_unit:
      return "in the wrong unit of time";
    case TimeFate::before_origin:
      return "before the origin";
    case TimeFate::repeated:
      return "doubled";
  }
  return "";
}

}  // namespace

WideNanoseconds LogTimes::since_origin_of(const TimeText& text) const {
  return (text.kind == Kind::number ? scaled(text.count, unit_) : text.count) - origin_;
}

void LogTimes::begin(const TimeText& text) {
  begun_ = true;
  unit_ = options_.unit.value_or(unit_by_size(text.kind == Kind::number ? text.count : 0));
  if (text.kind == Kind::number && !options_.unit && unit_ != automata::Ticks::per_second) {
    remarks_.push_back("the times are so great that they are taken for Unix time in " +
                       std::string(name_of_unit(unit_)));
  }
  if (options_.origin) {
    const TimeText& origin = *options_.origin;
    origin_ = origin.kind == Kind::number ? scaled(origin.count, options_.unit.value_or(unit_by_size(origin.count)))
                                          : origin.count;
  } else if (options_.from_first || text.kind == Kind::date) {
    origin_ = since_origin_of(text);
    if (!options_.from_first) {
      remarks_.push_back("the times are dates, and count from the first, " + format_date(origin_) +
                         "; --origin TIME names another start");
    }
  }
}

bool LogTimes::may_be_in_another_unit(WideNanoseconds time) const {
  const WideNanoseconds distance = time < last_ ? last_ - time : time - last_;
  if (longest_ == 0 || distance <= 100 * longest_) return false;
  const auto follows = [&](WideNanoseconds other) {
    return other - origin_ > last_ && other - origin_ <= last_ + 2 * longest_;
  };
  const WideNanoseconds as_written = time + origin_;
  for (WideNanoseconds factor = 1000; factor <= second; factor *= 1000) {
    if (follows(as_written / factor) || follows(as_written * factor)) return true;
  }
  return false;
}

std::optional<LogTimes::Place> LogTimes::place(const TimeText& text, const Peek& peek) {
  if (!begun_) begin(text);
  if (text.kind == Kind::number && !options_.unit && unit_by_size(text.count) != unit_) {
    return Place{{}, TimeFate::wrong_unit};
  }
  const WideNanoseconds time = since_origin_of(text);
  if (may_be_in_another_unit(time)) {
    const std::optional<TimeText> next = time < last_ ? std::nullopt : peek();
    if (time < last_ || (next && since_origin_of(*next) < time)) return Place{{}, TimeFate::wrong_unit};
  }
  if (time < 0) return Place{{}, TimeFate::before_origin};
  if (time >= std::numeric_limits<std::int64_t>::max()) return std::nullopt;
  const automata::Ticks ticks{static_cast<std::int64_t>(time)};
  if (time < last_) return Place{ticks, TimeFate::out_of_order};
  if (last_ == 0 && time > day && !options_.from_first && !options_.origin) {
    remarks_.push_back("the first step lasts " + automata::format_seconds(ticks) + " s, " +
                       std::to_string(static_cast<std::int64_t>(time / day)) +
                       " days: expected times since the start; --origin first counts from the first time of the log, "
                       "--origin TIME from a number or date");
  }
  if (std::exchange(placed_, true)) longest_ = std::max(longest_, time - last_);
  last_ = time;
  return Place{ticks, TimeFate::follows};
}

void LogTimes::leave_out(TimeFate fate, std::size_t line) {
  Count& count = counts_[static_cast<std::size_t>(fate)];
  if (count.samples++ == 0) count.first_line = line;
}

std::vector<std::string> LogTimes::take_remarks() { return std::exchange(remarks_, {}); }

std::vector<std::string> LogTimes::left_out() const {
  std::vector<std::string> lines;
  for (const TimeFate fate :
       {TimeFate::before_origin, TimeFate::out_of_order, TimeFate::repeated, TimeFate::wrong_unit}) {
    const Count& count = counts_[static_cast<std::size_t>(fate)];
    if (count.samples == 0) continue;
    lines.push_back(std::to_string(count.samples) + (count.samples == 1 ? " sample " : " samples ") +
                    std::string(what_is_odd(fate)) + (count.samples == 1 ? " was" : " were") + " left out, " +
                    (count.samples == 1 ? "in line " : "the first in line ") + std::to_string(count.first_line));
  }
  return lines;
}

}  // namespace rmpl::runtime
