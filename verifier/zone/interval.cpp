// Closed intervals of clock readings.
// SPDX-License-Identifier: MIT
#include "verifier/zone/interval.hpp"

#include <algorithm>

namespace rmpl::verifier {

Interval intersection(const Interval& a, const Interval& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

std::vector<Interval> merged(std::vector<Interval> intervals) {
  std::erase_if(intervals, [](const Interval& i) { return i.empty(); });
  std::sort(intervals.begin(), intervals.end());
  std::vector<Interval> result;
  for (const Interval& next : intervals) {
    if (!result.empty() && (result.back().upper == unbounded || next.lower <= result.back().upper + 1)) {
      result.back().upper = std::max(result.back().upper, next.upper);
    } else {
      result.push_back(next);
    }
  }
  return result;
}

std::vector<Interval> gaps(const std::vector<Interval>& intervals) {
  std::vector<Interval> result;
  Units end = 0;
  for (const Interval& next : intervals) {
    if (next.lower > end) result.push_back({end, next.lower});
    if (next.upper == unbounded) return result;
    end = next.upper;
  }
  result.push_back({end, unbounded});
  return result;
}

}  // namespace rmpl::verifier
