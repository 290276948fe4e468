// Concrete times for a symbolic path: the earliest ones.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "verifier/zone/interval.hpp"

namespace rmpl::verifier {

/// A system of difference constraints over points in time. The first point is time 0. Its least solution makes every
/// point as early as it can be, all at once: the longest paths from the first point (R. Bellman, On a Routing Problem,
/// 1958).
class Schedule {
 public:
  using Point = std::size_t;

  /// A point that comes no earlier than time 0.
  Point add_point();
  /// `later` - `earlier` is within the interval.
  void constrain(Point earlier, Point later, const Interval& distance);
  /// `later` - `earlier` is exactly `distance`.
  void fix(Point earlier, Point later, Units distance) { constrain(earlier, later, {distance, distance}); }

  /// The earliest times, by point; nothing where the constraints contradict each other.
  [[nodiscard]] std::optional<std::vector<Units>> solve() const;

 private:
  /// time[later] >= time[earlier] + distance
  struct AtLeast {
    Point earlier;
    Point later;
    Units distance;
  };
  std::size_t points_ = 1;
  std::vector<AtLeast> constraints_;
};

}  // namespace rmpl::verifier
