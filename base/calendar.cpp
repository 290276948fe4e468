// A year and a month have no fixed length.
// SPDX-License-Identifier: MIT
#include "base/calendar.hpp"

#include <algorithm>
#include <array>

namespace rmpl::base {

std::optional<std::string> calendar_reason(std::string_view unit) {
  constexpr std::array<std::string_view, 5> years{"y", "yr", "yrs", "year", "years"};
  constexpr std::array<std::string_view, 4> months{"mo", "mon", "month", "months"};
  const auto among = [&](const auto& words) { return std::find(words.begin(), words.end(), unit) != words.end(); };
  if (among(years)) return "a year has no fixed length: write days, `365 d`, or `365.25 d` for the Julian year";
  if (among(months)) return "a month has no fixed length: write days, `30 d`";
  return std::nullopt;
}

}  // namespace rmpl::base
