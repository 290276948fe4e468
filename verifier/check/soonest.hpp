// The least time by which something can be reached.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>

#include "verifier/property/property.hpp"
#include "verifier/witness/witness.hpp"
#include "verifier/zone/time_model.hpp"

namespace rmpl::verifier {

/// The window in whole units.
inline Interval interval_of(const Window& window, const TimeModel& time) {
  Interval result;
  if (window.not_before) result.lower = time.at_least(*window.not_before);
  if (window.by) result.upper = time.at_most(*window.by);
  return result;
}

/// Has `best` be the soonest within the window: each round asks `search` for a run that takes less time than the best
/// so far, until there is none. What `search` throws leaves the best so far.
template <class Search>
void hasten(std::optional<Witness>& best, Interval window, const TimeModel& time, const Search& search) {
  while (best && best->events.back().time > automata::Ticks{0}) {
    window.upper = time.at_most(best->events.back().time) - 1;
    if (window.upper < window.lower) return;
    std::optional<Witness> sooner = search(window);
    if (!sooner) return;
    best = std::move(sooner);
  }
}

}  // namespace rmpl::verifier
