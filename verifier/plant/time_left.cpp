// The least time that the components need to a target.
// SPDX-License-Identifier: MIT
#include "verifier/plant/time_left.hpp"

#include <algorithm>

namespace rmpl::verifier {

using automata::Component;
using automata::ComponentId;
using automata::ModeId;
using automata::Transition;

namespace {

Units sum(Units a, Units b) { return a == unbounded || b == unbounded ? unbounded : a + b; }

/// The fewest units that the transition takes from when its mode was entered.
Units least(const Transition& transition, const TimeModel& time) {
  const Units bound = transition.timing ? time.at_least(transition.timing->lower) : 0;
  return time.is_dense() ? bound : std::max<Units>(bound, 1);
}

}  // namespace

TimeLeft::TimeLeft(automata::PlantStep& step, const TimeModel& time, const automata::Formula& target, bool faults,
                   Units by)
    : by_(by) {
  const automata::Theory::Handle handle = step.theory().encode(target);
  for (const ComponentId c : step.locality().support_of(target).components) {
    const Component& component = step.plant()[c];
    Way way{c, std::vector<Left>(component.modes.size())};
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const automata::Assignment here{component.mode, automata::ValueId(m)};
      if (step.theory().allows({&here, 1}, handle)) way.left[m] = {0, 0};
    }
    // Bellman's rounds: components have few modes.
    for (bool changed = true; changed;) {
      changed = false;
      for (const Transition& t : component.transitions) {
        if (t.from == t.to || (component.is_fault(t) && !faults)) continue;
        Left& left = way.left[t.from.index()];
        const Units after = way.left[t.to.index()].since_entry;
        const Units all = sum(least(t, time), after);
        changed = changed || all < left.since_entry || after < left.after_exit;
        left = {std::min(left.since_entry, all), std::min(left.after_exit, after)};
      }
    }
    const bool needs_time =
        std::any_of(way.left.begin(), way.left.end(), [](const Left& left) { return left.since_entry > 0; });
    if (needs_time) ways_.push_back(std::move(way));
  }
}

bool TimeLeft::cut(Zone& zone, const automata::Modes& modes, const std::vector<ComponentId>& live) const {
  constexpr std::size_t stopwatch = 1;
  for (const Way& way : ways_) {
    const Left& left = way.left[modes[way.component.index()].index()];
    if (left.after_exit > by_ || !zone.constrain(stopwatch, {0, by_ - left.after_exit})) return false;
    const auto at = std::lower_bound(live.begin(), live.end(), way.component);
    if (at == live.end() || *at != way.component) continue;
    const auto clock = stopwatch + 1 + static_cast<std::size_t>(at - live.begin());
    // How long before the mode was entered time began stays as it is while the mode lasts.
    if (left.since_entry > by_ || !zone.constrain(stopwatch, clock, by_ - left.since_entry)) return false;
  }
  return true;
}

}  // namespace rmpl::verifier
