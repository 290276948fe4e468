// Rounds that take no time in dense time, and a cycle each in cycles.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <set>
#include <vector>

#include "automata/plant.hpp"

namespace rmpl::property {

/// Whether some component may go round in no time, whatever the guards: in cycles that takes time, as often as it
/// likes.
inline bool goes_round_at_once(const automata::Plant& plant) {
  return std::any_of(plant.components.begin(), plant.components.end(), [](const automata::Component& component) {
    const std::size_t modes = component.modes.size();
    std::vector<std::set<std::size_t>> reached(modes);
    for (std::size_t round = 0; round < modes; ++round) {
      for (const automata::Transition& t : component.transitions) {
        const bool at_once = !component.is_fault(t) && (!t.timing || t.timing->lower == automata::Ticks{0});
        if (!at_once || (t.from == t.to && !t.restart)) continue;
        std::set<std::size_t>& from = reached[t.from.index()];
        from.insert(t.to.index());
        const std::set<std::size_t> then = reached[t.to.index()];
        from.insert(then.begin(), then.end());
      }
    }
    for (std::size_t m = 0; m < modes; ++m) {
      if (reached[m].contains(m)) return true;
    }
    return false;
  });
}

}  // namespace rmpl::property
