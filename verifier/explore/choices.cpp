// What one component may do in one step.
// SPDX-License-Identifier: MIT
#include "verifier/explore/choices.hpp"

#include <algorithm>

namespace verifier {

using automata::Component;
using automata::Enabled;
using automata::ModeId;
using automata::Timing;
using automata::Transition;
using automata::TransitionId;

namespace {

/// The choices of one component, as they are collected.
class Collector {
 public:
  Collector(const Component& component, ModeId mode, const Enabled& enabled, const Reading& reading)
      : component_(component), mode_(mode), enabled_(enabled), reading_(reading) {}

  std::vector<Choice> collect() {
    for (const TransitionId id : enabled_.faults) {
      const Transition& t = component_.transitions[id.index()];
      add(t.to, t.to == mode_ ? 0 : 1, within(t));
    }
    for (const Interval& share : nominal_share()) add_nominal(share);
    std::sort(result_.begin(), result_.end());
    result_.erase(std::unique(result_.begin(), result_.end()), result_.end());
    return std::move(result_);
  }

 private:
  void add(ModeId to, unsigned faults, const Interval& clock) {
    if (!clock.empty()) result_.push_back({to, faults, clock});
  }

  /// Where a fault transition is enabled.
  [[nodiscard]] Interval within(const Transition& t) const {
    if (!t.timing) return {};
    return {reading_.at_least(t.timing->lower), reading_.at_most(t.timing->upper)};
  }

  /// The sum of the fault probabilities at a reading, in the order in which PlantStep adds them.
  [[nodiscard]] double faulty(Units clock) const {
    double sum = 0;
    for (const TransitionId id : enabled_.faults) {
      const Transition& t = component_.transitions[id.index()];
      if (within(t).contains(clock))
        sum += t.weight.fault_probability(reading_.is_dense() ? automata::Ticks{0} : reading_.unit());
    }
    return sum;
  }

  /// The readings at which the faults leave a nominal share. Between the bounds of timed faults the sum is constant, so
  /// one look at each piece decides. Outside a certain fault's bounds is the one open condition there is: in dense time
  /// it is taken at whole units.
  [[nodiscard]] std::vector<Interval> nominal_share() const {
    std::vector<Units> starts = {0};
    for (const TransitionId id : enabled_.faults) {
      const Interval clock = within(component_.transitions[id.index()]);
      starts.push_back(clock.lower);
      if (clock.upper != unbounded) starts.push_back(clock.upper + 1);
    }
    std::sort(starts.begin(), starts.end());
    starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
    std::vector<Interval> pieces;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const Units end = i + 1 < starts.size() ? starts[i + 1] - 1 : unbounded;
      if (faulty(starts[i]) < 1) pieces.push_back({starts[i], end});
    }
    return merged(std::move(pieces));
  }

  void add_nominal(const Interval& share) {
    if (!enabled_.untimed.empty()) {
      for (const TransitionId id : enabled_.untimed) add(component_.transitions[id.index()].to, 0, share);
      return;
    }
    if (reading_.is_dense()) {
      add(mode_, 0, share);
      Units certain = unbounded;
      for (const TransitionId id : enabled_.timed) {
        certain = std::min(certain, reading_.at_most(component_.transitions[id.index()].timing->upper));
      }
      for (const TransitionId id : enabled_.timed) {
        const Transition& t = component_.transitions[id.index()];
        add(t.to, 0, intersection(share, {reading_.at_least(t.timing->lower), certain}));
        if (t.timing->upper.is_infinite()) continue;
        add(t.to, 0, intersection(share, {reading_.at_most(t.timing->upper), unbounded}));
      }
      return;
    }
    Units certain = unbounded;
    for (const TransitionId id : enabled_.timed) {
      certain = std::min(certain, reading_.at_least(component_.transitions[id.index()].timing->upper));
    }
    const Units before = certain == unbounded ? unbounded : certain - 1;
    add(mode_, 0, intersection(share, {0, before}));
    for (const TransitionId id : enabled_.timed) {
      const Transition& t = component_.transitions[id.index()];
      add(t.to, 0, intersection(share, {reading_.more_than(t.timing->lower), before}));
      if (!t.timing->upper.is_infinite()) {
        add(t.to, 0, intersection(share, {reading_.at_least(t.timing->upper), unbounded}));
      }
    }
  }

  const Component& component_;
  ModeId mode_;
  const Enabled& enabled_;
  const Reading& reading_;
  std::vector<Choice> result_;
};

}  // namespace

std::vector<Choice> choices(const Component& component, ModeId mode, const Enabled& enabled, const Reading& reading) {
  return Collector(component, mode, enabled, reading).collect();
}

std::vector<Interval> waits(const Component& component, ModeId mode, const Enabled& enabled, const Reading& reading) {
  if (reading.is_dense()) {
    const auto leaves = [&](TransitionId id) { return component.transitions[id.index()].to != mode; };
    if (std::any_of(enabled.untimed.begin(), enabled.untimed.end(), leaves)) return {};
    Interval wait;
    if (!enabled.untimed.empty()) return {wait};
    for (const TransitionId id : enabled.timed) {
      if (!leaves(id)) continue;
      wait.upper = std::min(wait.upper, reading.at_most(component.transitions[id.index()].timing->upper));
    }
    return {wait};
  }
  // A wait is a run of periods in each of which the component may stay; the first one ends a unit after it begins.
  std::vector<Interval> stays;
  for (const Choice& choice : choices(component, mode, enabled, reading)) {
    if (choice.mode == mode && choice.faults == 0) stays.push_back(choice.clock);
  }
  stays = merged(std::move(stays));
  for (Interval& stay : stays) stay.lower = std::max<Units>(stay.lower - 1, 0);
  return stays;
}

ClockLimits clock_limits(const Component& component, ModeId mode, const Reading& reading) {
  ClockLimits limits;
  for (const Transition& t : component.transitions) {
    if (t.from != mode || !t.timing) continue;
    const Units lower = reading.more_than(t.timing->lower);
    limits.lower = std::max(limits.lower, lower);
    // Every bound cuts both ways: it ends one interval and begins the next, at a fault's bounds and between an exit's
    // being possible and its being certain.
    limits.upper = std::max(limits.upper, lower);
    if (t.timing->upper.is_infinite()) continue;
    const Units upper = reading.more_than(t.timing->upper);
    limits.upper = std::max(limits.upper, upper);
    limits.lower = std::max(limits.lower, upper);
  }
  return limits;
}

}  // namespace verifier
