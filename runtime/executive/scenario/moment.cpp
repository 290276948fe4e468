// Seconds, and hours, minutes and seconds.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/moment.hpp"

#include <algorithm>

namespace rmpl::runtime {
namespace {

using automata::Ticks;

constexpr Ticks minute = Ticks::of_seconds(60);

std::string two_digits(std::int64_t number) { return (number < 10 ? "0" : "") + std::to_string(number); }

std::string right_aligned(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

/// The point and the digits behind it, or nothing.
std::string decimals(Ticks time) {
  const std::string text = automata::format_seconds({time.count % Ticks::per_second});
  return text == "0" ? "" : text.substr(1);
}

}  // namespace

std::string hours_minutes_seconds(Ticks time) {
  const std::int64_t seconds = time.count / Ticks::per_second;
  return std::to_string(seconds / 3600) + ":" + two_digits(seconds / 60 % 60) + ":" + two_digits(seconds % 60) +
         decimals(time);
}

std::string moment(Ticks time) {
  const std::string seconds = automata::format_seconds(time) + " s";
  return time < minute ? seconds : seconds + " (" + hours_minutes_seconds(time) + ")";
}

MomentColumn::MomentColumn(Ticks end, Ticks cycle) {
  const std::size_t digits = decimals(cycle).size();
  const Ticks whole{end.count - end.count % Ticks::per_second};
  seconds_width_ = automata::format_seconds(whole).size() + digits + 2;
  if (end >= minute) clock_width_ = hours_minutes_seconds(whole).size() + digits;
}

std::string MomentColumn::text(Ticks time) const {
  std::string text = right_aligned(automata::format_seconds(time) + " s", seconds_width_);
  if (clock_width_ == 0) return text;
  return text + "  " + right_aligned(time < minute ? "" : hours_minutes_seconds(time), clock_width_);
}

}  // namespace rmpl::runtime
