// From the clock that was started last to the one that was started first, each as little as may be.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/clock_order.hpp"

#include <algorithm>
#include <iterator>

#include "compiler/lint/program/possibilities.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::Ticks;

ClockOrder::ClockOrder(const std::vector<const Formula*>& formulas) : bounds_(clock_bounds_of(formulas)) {
  for (auto& [clock, bounds] : bounds_) {
    bounds.push_back(Ticks{0});
    std::sort(bounds.begin(), bounds.end());
  }
}

ClockOrder::Stretch ClockOrder::stretch_of(const RunningClock& clock) const {
  const std::vector<Ticks>& bounds = bounds_.at(clock.clock);
  const auto above = std::lower_bound(bounds.begin(), bounds.end(), clock.reading);
  if (above != bounds.end() && *above == clock.reading) return {clock.reading, clock.reading};
  const Ticks below = above == bounds.begin() ? Ticks{0} : *std::prev(above);
  return {below + Ticks{1}, above == bounds.end() ? Ticks::infinite() : *above - Ticks{1}};
}

std::vector<Ticks> ClockOrder::least(std::vector<RunningClock>& clocks) const {
  std::stable_sort(clocks.begin(), clocks.end(),
                   [](const RunningClock& a, const RunningClock& b) { return a.rank > b.rank; });
  std::vector<Ticks> result;
  Ticks before{0};
  for (std::size_t c = 0; c < clocks.size();) {
    Stretch all{before + Ticks{1}, Ticks::infinite()};
    std::size_t end = c;
    for (; end < clocks.size() && clocks[end].rank == clocks[c].rank; ++end) {
      const Stretch one = stretch_of(clocks[end]);
      all.first = std::max(all.first, one.first);
      if (!clocks[end].at_least) all.last = std::min(all.last, one.last);
    }
    if (all.last < all.first) return {};
    result.insert(result.end(), end - c, all.first);
    before = all.first;
    c = end;
  }
  return result;
}

}  // namespace rmpl::compiler
