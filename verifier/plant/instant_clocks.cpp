// The clocks of an instant.
// SPDX-License-Identifier: MIT
#include "verifier/plant/instant_clocks.hpp"

#include <algorithm>

namespace rmpl::verifier {

using automata::ComponentId;

std::optional<std::size_t> InstantClocks::clock_of(ComponentId component) const {
  const auto at = std::lower_bound(live_.begin(), live_.end(), component);
  if (at == live_.end() || *at != component) return std::nullopt;
  return 1 + others_ + static_cast<std::size_t>(at - live_.begin());
}

std::optional<ZoneBox> InstantClocks::translated(const Box& box, Units earlier, Units before_end) const {
  ZoneBox result;
  for (const ClockBound& bound : box) {
    Interval range{std::max<Units>(bound.clock.lower - earlier, 0), bound.clock.upper};
    if (range.upper != unbounded) range.upper -= before_end;
    if (range.empty()) return std::nullopt;
    if (const auto clock = clock_of(bound.component)) {
      result.push_back({*clock, range});
    } else if (!range.contains(0)) {
      return std::nullopt;
    }
  }
  return result;
}

std::vector<ZoneBox> certain_faults(std::span<const ClockBound> faulty, const InstantClocks& clocks,
                                    const TimeModel& time) {
  const Units period = time.is_dense() ? 0 : 1;
  std::vector<ZoneBox> result;
  for (const ClockBound& bound : faulty) {
    if (auto box = clocks.translated({bound}, period, period)) result.push_back(std::move(*box));
  }
  return result;
}

std::vector<std::size_t> InstantClocks::restarted(const automata::Modes& from, const automata::Modes& to) const {
  std::vector<std::size_t> result;
  for (std::size_t c = 0; c < from.size(); ++c) {
    if (from[c] == to[c]) continue;
    if (const auto clock = clock_of(ComponentId(c))) result.push_back(*clock);
  }
  return result;
}

}  // namespace rmpl::verifier
