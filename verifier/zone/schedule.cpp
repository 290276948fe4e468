// Concrete times for a symbolic path.
// SPDX-License-Identifier: MIT
#include "verifier/zone/schedule.hpp"

namespace rmpl::verifier {

Schedule::Point Schedule::add_point() { return points_++; }

void Schedule::constrain(Point earlier, Point later, const Interval& distance) {
  constraints_.push_back({earlier, later, distance.lower});
  if (distance.upper != unbounded) constraints_.push_back({later, earlier, -distance.upper});
}

std::optional<std::vector<Units>> Schedule::solve() const {
  std::vector<Units> time(points_, 0);
  for (std::size_t round = 0; round <= points_; ++round) {
    bool changed = false;
    for (const AtLeast& c : constraints_) {
      if (time[c.later] >= time[c.earlier] + c.distance) continue;
      time[c.later] = time[c.earlier] + c.distance;
      changed = true;
    }
    if (!changed) return time[0] == 0 ? std::optional(time) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace rmpl::verifier
