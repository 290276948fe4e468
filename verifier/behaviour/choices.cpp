// What one component may do in one step.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/choices.hpp"

#include <algorithm>

#include "automata/step/transition_rules.hpp"

namespace rmpl::verifier {

using automata::Component;
using automata::Enabled;
using automata::ModeId;
using automata::Transition;
using automata::TransitionId;

namespace {

/// Each mode's intervals with equal cost, those that overlap joined; sorted.
std::vector<Choice> joined(std::vector<Choice> choices) {
  std::sort(choices.begin(), choices.end());
  std::vector<Choice> result;
  for (const Choice& choice : choices) {
    const bool joins = !result.empty() && result.back().mode == choice.mode && result.back().faults == choice.faults &&
                       choice.clock.lower <= result.back().clock.upper;
    if (!joins) {
      result.push_back(choice);
      continue;
    }
    Choice& all = result.back();
    if (choice.clock.lower == all.clock.lower) all.sharp.lower = all.sharp.lower && choice.sharp.lower;
    if (choice.clock.upper == all.clock.upper) all.sharp.upper = all.sharp.upper && choice.sharp.upper;
    if (choice.clock.upper > all.clock.upper) all.sharp.upper = choice.sharp.upper;
    all.clock.upper = std::max(all.clock.upper, choice.clock.upper);
  }
  return result;
}

/// The choices of one component, as they are collected.
class Collector {
 public:
  Collector(const Component& component, ModeId mode, const Enabled& enabled, const TimeModel& time)
      : component_(component), mode_(mode), enabled_(enabled), time_(time) {}

  std::vector<Choice> collect() {
    for (const TransitionId id : enabled_.faults) {
      const Transition& t = component_.transitions[id.index()];
      add(t.to, t.to == mode_ ? 0 : 1, within(t));
    }
    for (const Interval& share : nominal_share()) add_nominal(share);
    return joined(std::move(result_));
  }

 private:
  void add(ModeId to, unsigned faults, const Interval& clock) {
    if (!clock.empty()) result_.push_back({to, faults, clock});
  }

  /// Those bounds of the interval are sharp that the share leaves as they are.
  void add_within(const Interval& share, ModeId to, const Interval& clock, const Sharp& sharp) {
    const Interval both = intersection(share, clock);
    if (both.empty()) return;
    result_.push_back(
        {to, 0, both, {sharp.lower && both.lower == clock.lower, sharp.upper && both.upper == clock.upper}});
  }

  /// Where a fault transition is enabled.
  [[nodiscard]] Interval within(const Transition& t) const {
    if (!t.timing) return {};
    return {time_.at_least(t.timing->lower), time_.at_most(t.timing->upper)};
  }

  [[nodiscard]] bool leaves_a_share(Units clock) const {
    const automata::Ticks unit = time_.unit();
    const automata::Ticks step = time_.is_dense() ? automata::Ticks{0} : unit;
    return automata::nominal_share(component_, enabled_, automata::Ticks{clock * unit.count}, step) > 0;
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
      if (leaves_a_share(starts[i])) pieces.push_back({starts[i], end});
    }
    return merged(std::move(pieces));
  }

  void add_nominal(const Interval& share) {
    if (!enabled_.untimed.empty()) {
      for (const TransitionId id : enabled_.untimed) add(component_.transitions[id.index()].to, 0, share);
      return;
    }
    if (time_.is_dense()) {
      Units certain = unbounded;
      for (const TransitionId id : enabled_.timed) {
        certain = std::min(certain, time_.at_most(component_.transitions[id.index()].timing->upper));
      }
      const bool ends = certain != unbounded;
      add_within(share, mode_, {0, certain}, {false, ends});
      for (const TransitionId id : enabled_.timed) {
        const Transition& t = component_.transitions[id.index()];
        const Units lower = time_.at_least(t.timing->lower);
        const Units upper = time_.at_most(t.timing->upper);
        add_within(share, t.to, {lower, certain}, {0 < lower && lower < upper, ends && certain < upper});
        if (upper != unbounded) add_within(share, t.to, {upper, unbounded}, {});
      }
      return;
    }
    Units certain = unbounded;
    for (const TransitionId id : enabled_.timed) {
      certain = std::min(certain, time_.at_least(component_.transitions[id.index()].timing->upper));
    }
    const Units before = certain == unbounded ? unbounded : certain - 1;
    add(mode_, 0, intersection(share, {0, before}));
    for (const TransitionId id : enabled_.timed) {
      const Transition& t = component_.transitions[id.index()];
      add(t.to, 0, intersection(share, {time_.more_than(t.timing->lower), before}));
      if (!t.timing->upper.is_infinite()) {
        add(t.to, 0, intersection(share, {time_.at_least(t.timing->upper), unbounded}));
      }
    }
  }

  const Component& component_;
  ModeId mode_;
  const Enabled& enabled_;
  const TimeModel& time_;
  std::vector<Choice> result_;
};

}  // namespace

std::vector<Choice> choices(const Component& component, ModeId mode, const Enabled& enabled, const TimeModel& time) {
  return Collector(component, mode, enabled, time).collect();
}

std::vector<Interval> without_nominal(const std::vector<Choice>& choices) {
  std::vector<Interval> nominal;
  for (const Choice& choice : choices) {
    if (choice.faults == 0) nominal.push_back(choice.clock);
  }
  std::vector<Interval> result;
  Units next = 0;
  for (const Interval& some : merged(std::move(nominal))) {
    if (some.lower > next) result.push_back({next, some.lower - 1});
    if (some.upper == unbounded) return result;
    next = some.upper + 1;
  }
  result.push_back({next, unbounded});
  return result;
}

namespace {

/// What the intervals, ascending, leave of another, and where they begin: time passes up to there.
std::vector<Interval> outside(Interval rest, const std::vector<Interval>& intervals) {
  std::vector<Interval> result;
  for (const Interval& taken : intervals) {
    if (rest.lower < taken.lower && !rest.empty()) result.push_back({rest.lower, std::min(rest.upper, taken.lower)});
    if (taken.upper == unbounded) return result;
    rest.lower = std::max(rest.lower, taken.upper + 1);
  }
  if (!rest.empty()) result.push_back(rest);
  return result;
}

/// Where the component may stay in a step.
std::vector<Interval> stays_of(const Component& component, ModeId mode, const Enabled& enabled, const TimeModel& time) {
  std::vector<Interval> stays;
  for (const Choice& choice : choices(component, mode, enabled, time)) {
    if (choice.mode == mode && choice.faults == 0) stays.push_back(choice.clock);
  }
  return merged(std::move(stays));
}

/// The waits of one whose clock restarts: nothing, where it may not stay after that.
std::vector<Interval> restarted_waits(std::vector<Interval> stays, const TimeModel& time) {
  const Units period = time.is_dense() ? 0 : 1;
  const auto has = [period](const Interval& stay) { return stay.contains(period); };
  if (std::none_of(stays.begin(), stays.end(), has)) return {};
  for (Interval& stay : stays) {
    stay.lower = std::max<Units>(stay.lower - period, 0);
    if (stay.upper != unbounded) stay.upper -= period;
  }
  std::erase_if(stays, [](const Interval& stay) { return stay.empty(); });
  return stays;
}

}  // namespace

std::vector<Interval> waits(const Component& component, ModeId mode, const Enabled& enabled, const TimeModel& time) {
  if (time.is_dense()) {
    const auto leaves = [&](TransitionId id) { return component.transitions[id.index()].to != mode; };
    if (std::any_of(enabled.untimed.begin(), enabled.untimed.end(), leaves)) return {};
    if (automata::restarts(component, enabled)) return restarted_waits(stays_of(component, mode, enabled, time), time);
    Interval wait;
    if (!enabled.untimed.empty()) return {wait};
    for (const TransitionId id : enabled.timed) {
      if (!leaves(id)) continue;
      wait.upper = std::min(wait.upper, time.at_most(component.transitions[id.index()].timing->upper));
    }
    if (enabled.faults.empty()) return {wait};
    return outside(wait, without_nominal(choices(component, mode, enabled, time)));
  }
  // A wait is a run of periods in each of which the component may stay; the first one ends a unit after it begins.
  std::vector<Interval> stays = stays_of(component, mode, enabled, time);
  if (automata::restarts(component, enabled)) return restarted_waits(std::move(stays), time);
  for (Interval& stay : stays) stay.lower = std::max<Units>(stay.lower - 1, 0);
  return stays;
}

namespace {

/// Whether the faults that start in the mode can leave no nominal share.
bool faults_can_be_certain(const Component& component, ModeId mode) {
  double sum = 0;
  for (const Transition& t : component.transitions) {
    if (t.from != mode || !component.is_fault(t)) continue;
    sum += t.weight.kind == automata::Weight::Kind::rate ? 0 : t.weight.value;
  }
  return sum >= 1;
}

/// In sampled time, and beside faults that can be certain, every bound cuts both ways: it ends one interval and begins
/// the next.
ClockLimits coarse_limits(const Component& component, ModeId mode, const TimeModel& time) {
  Units greatest = -1;
  for (const Transition& t : component.transitions) {
    if (t.from != mode || !t.timing) continue;
    greatest = std::max(greatest, time.more_than(t.timing->lower));
    if (!t.timing->upper.is_infinite()) greatest = std::max(greatest, time.more_than(t.timing->upper));
  }
  return {greatest, greatest};
}

}  // namespace

ClockLimits clock_limits(const Component& component, ModeId mode, const TimeModel& time,
                         const std::vector<bool>& possible) {
  if (!time.is_dense() || faults_can_be_certain(component, mode)) return coarse_limits(component, mode, time);
  const auto exits =
      std::count_if(component.transitions.begin(), component.transitions.end(),
                    [&](const Transition& t) { return t.from == mode && t.timing && !component.is_fault(t); });
  ClockLimits limits;
  for (const Transition& t : component.transitions) {
    if (t.from != mode || !t.timing) continue;
    const bool finite = !t.timing->upper.is_infinite();
    const Units lower = time.at_least(t.timing->lower);
    const Units upper = finite ? time.at_most(t.timing->upper) : -1;
    limits.upper = std::max(limits.upper, upper);
    // What leads into an impossible mode is never taken: only time stops for it.
    if (!possible.empty() && !possible[t.to.index()]) continue;
    limits.lower = std::max(limits.lower, lower);
    // Alone, an exit is possible from its lower bound on. Another may be certain between its bounds, and exclude it
    // until its own upper bound.
    if (exits > 1 && !component.is_fault(t)) limits.lower = std::max(limits.lower, upper);
  }
  return limits;
}

}  // namespace rmpl::verifier
