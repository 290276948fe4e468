// Closed intervals of clock readings, in whole units of time.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace rmpl::verifier {

/// A number of time units: what one unit is, the model of time says (zone/time_model.hpp).
using Units = std::int64_t;

/// No upper bound.
inline constexpr Units unbounded = std::numeric_limits<Units>::max();

/// The readings from `lower` to `upper`, both included; `upper` may be `unbounded`. Empty where lower > upper.
struct Interval {
  Units lower = 0;
  Units upper = unbounded;
  auto operator<=>(const Interval&) const = default;

  [[nodiscard]] bool empty() const { return lower > upper; }
  [[nodiscard]] bool is_trivial() const { return lower <= 0 && upper == unbounded; }
  [[nodiscard]] bool contains(Units reading) const { return lower <= reading && reading <= upper; }
};

/// The readings in both.
Interval intersection(const Interval& a, const Interval& b);

/// The same readings as fewest intervals, ascending: those that overlap or follow each other unit on unit become one.
std::vector<Interval> merged(std::vector<Interval> intervals);

/// The readings before, between and after the intervals, which ascend and are apart. The ends are included: those of a
/// gap are those of its neighbours.
std::vector<Interval> gaps(const std::vector<Interval>& intervals);

}  // namespace rmpl::verifier
