// The clocks of an instant.
// SPDX-License-Identifier: MIT
#include "verifier/plant/instant_clocks.hpp"

#include <algorithm>

namespace rmpl::verifier {

using automata::ComponentId;

namespace {

/// Whether so many of the boxes hold at one reading of the zone.
bool hold_together(const Zone& zone, std::span<const ZoneBox> boxes, std::size_t count) {
  if (count == 0) return true;
  for (std::size_t first = 0; first + count <= boxes.size(); ++first) {
    Zone within = zone;
    const bool holds = std::all_of(boxes[first].begin(), boxes[first].end(),
                                   [&](const ZoneBound& b) { return within.constrain(b.clock, b.range); });
    if (holds && hold_together(within, boxes.subspan(first + 1), count - 1)) return true;
  }
  return false;
}

}  // namespace

template <class Range>
std::optional<ZoneBox> InstantClocks::translated(const Box& box, const Range& range_of) const {
  ZoneBox result;
  for (const ClockBound& bound : box) {
    const Interval range = range_of(bound);
    if (range.empty()) return std::nullopt;
    if (const auto clock = clock_of(bound.component)) {
      if (result.empty()) result.reserve(box.size());
      result.push_back({*clock, range});
    } else if (!range.contains(0)) {
      return std::nullopt;
    }
  }
  return result;
}

std::optional<std::size_t> InstantClocks::clock_of(ComponentId component) const {
  const auto at = std::lower_bound(live_.begin(), live_.end(), component);
  if (at == live_.end() || *at != component) return std::nullopt;
  return 1 + others_ + static_cast<std::size_t>(at - live_.begin());
}

std::optional<ZoneBox> InstantClocks::translated(const Box& box, Units earlier, Units before_end) const {
  return translated(box, [&](const ClockBound& bound) {
    Interval range{std::max<Units>(bound.clock.lower - earlier, 0), bound.clock.upper};
    if (range.upper != unbounded) range.upper -= before_end;
    return range;
  });
}

std::optional<ZoneBox> InstantClocks::lasting(const Box& box, bool at_bound) const {
  return translated(box, [&](const ClockBound& bound) {
    const Interval clock{std::max<Units>(bound.clock.lower, 0), bound.clock.upper};
    return verifier::lasting(clock, {bound.sharp.lower && at_bound, bound.sharp.upper});
  });
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

bool more_certain(const Zone& zone, std::span<const ClockBound> faulty, std::size_t left,
                  const std::vector<ComponentId>& live, std::size_t others, const TimeModel& time) {
  return left < faulty.size() &&
         hold_together(zone, certain_faults(faulty, InstantClocks(live, others), time), left + 1);
}

std::vector<std::size_t> InstantClocks::restarted(const automata::Modes& from, const automata::Modes& to,
                                                  const std::vector<ComponentId>& anew) const {
  std::vector<std::size_t> result;
  for (std::size_t c = 0; c < from.size(); ++c) {
    if (from[c] == to[c] && !std::binary_search(anew.begin(), anew.end(), ComponentId(c))) continue;
    if (const auto clock = clock_of(ComponentId(c))) result.push_back(*clock);
  }
  return result;
}

void InstantClocks::add_restarts(const Instant& step, const std::vector<ComponentId>& anew,
                                 base::FunctionRef<void(Instant&&)> add) const {
  for (const ComponentId component : anew) {
    const auto clock = clock_of(component);
    if (!clock) continue;
    Instant one = step;
    one.bounds.push_back({*clock, {1, unbounded}});
    one.restarts = {*clock};
    add(std::move(one));
  }
}

}  // namespace rmpl::verifier
