// Timetables: concrete times for a symbolic path of a plant.
// SPDX-License-Identifier: MIT
#include "verifier/plant/timetable.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "verifier/plant/itinerary.hpp"
#include "verifier/zone/schedule.hpp"

namespace rmpl::verifier {

namespace {

/// The points in time of one path: for each state when it is entered and when the wait in it ends.
class Timetable {
 public:
  Timetable(std::vector<Leg> legs, PlantSystem& system)
      : legs_(std::move(legs)),
        situations_(system.situations()),
        observer_(system.observer()),
        progress_(system.watches_progress()) {}

  TimedPath path() {
    begin();
    for (std::size_t i = 1; i < legs_.size(); ++i) step(i);
    accept();
    const auto times = schedule_.solve();
    CHECK(times && "a path that the search found has no times");
    TimedPath result;
    result.witness = events(*times, result.entered);
    return result;
  }

 private:
  void begin() {
    restarted_.assign(legs_[0].modes.size(), 0);
    entered_.push_back(0);
    wait(0);
  }

  /// From the end of the wait in state i - 1 to the end of the wait in state i.
  void step(std::size_t i) {
    const JointStep& taken = *legs_[i].move;
    const Schedule::Point left = left_.back();
    const Schedule::Point entered = schedule_.add_point();
    if (progress_) {
      const Interval waited = legs_[i].progressed ? Interval{situations_.time().grain(), unbounded} : Interval{0, 0};
      schedule_.constrain(entered_.back(), left, waited);
    }
    if (taken.hold) {
      pass(taken.bounds, taken.restarted, left, entered);
      if (progress_) schedule_.constrain(left, entered, {1, unbounded});
    } else {
      schedule_.fix(left, entered, situations_.time().is_dense() ? 0 : 1);
      for (const ClockBound& b : taken.bounds) schedule_.constrain(restarted(b), entered, b.clock);
    }
    entered_.push_back(entered);
    for (std::size_t c = 0; c < legs_[i].modes.size(); ++c) {
      if (legs_[i].modes[c] != legs_[i - 1].modes[c]) restarted_[c] = entered;
    }
    for (const automata::ComponentId c : taken.restarted) restarted_[c.index()] = entered;
    if (observer_.timed(legs_[i].phase) && !observer_.timed(legs_[i - 1].phase)) stopwatch_ = entered;
    wait(i);
  }

  void wait(std::size_t i) {
    const Schedule::Point left = schedule_.add_point();
    if (legs_[i].wait) {
      pass(*legs_[i].wait, legs_[i].restarted, entered_.back(), left);
      for (const automata::ComponentId c : legs_[i].restarted) restarted_[c.index()] = left;
    } else {
      schedule_.fix(entered_.back(), left, 0);
    }
    left_.push_back(left);
  }

  /// Time passes within a box of waits.
  void pass(const Box& box, const std::vector<automata::ComponentId>& anew, Schedule::Point from, Schedule::Point to) {
    schedule_.constrain(from, to, {anew.empty() ? 0 : 1, unbounded});
    for (const ClockBound& b : box) {
      if (std::binary_search(anew.begin(), anew.end(), b.component)) {
        schedule_.constrain(restarted(b), from, b.clock);
        continue;
      }
      schedule_.constrain(restarted(b), from, {b.clock.lower, unbounded});
      schedule_.constrain(restarted(b), to, {0, b.clock.upper});
    }
  }

  void accept() {
    if (legs_.back().end) {
      for (const ClockBound& b : *legs_.back().end) schedule_.constrain(restarted(b), left_.back(), b.clock);
      if (observer_.timed(legs_.back().cut_off)) {
        schedule_.constrain(stopwatch_, left_.back(), observer_.last_chance(situations_.time().grain()));
      }
    } else if (observer_.timed(legs_.back().phase)) {
      // A response that comes too late is so as it comes, however long one waits behind it.
      const Phase phase = legs_.back().phase;
      const bool comes = observer_.answers(phase, observer_.next(phase, legs_.back().modes));
      schedule_.constrain(stopwatch_, comes ? entered_.back() : left_.back(), *observer_.accepted());
    }
  }

  [[nodiscard]] Schedule::Point restarted(const ClockBound& bound) const { return restarted_[bound.component.index()]; }

  [[nodiscard]] Witness events(const std::vector<Units>& times, std::vector<std::size_t>& entered) const {
    const TimeModel& time = situations_.time();
    Witness witness;
    std::vector<Event>& result = witness.events;
    result.push_back({automata::Ticks{0}, legs_[0].modes, automata::idle_action(situations_.plant())});
    entered.push_back(0);
    for (std::size_t i = 1; i < legs_.size(); ++i) {
      const JointStep& taken = *legs_[i].move;
      // A hold is as many steps as it has periods.
      const Units first = taken.hold ? times[left_[i - 1]] + 1 : times[entered_[i]];
      for (Units at = first; at <= times[entered_[i]]; ++at) {
        result.push_back({time.ticks(at), legs_[i].modes, situations_.action(taken.action)});
        for (const automata::ComponentId c : taken.restarted) {
          if (legs_[i].modes[c.index()] == legs_[i - 1].modes[c.index()]) result.back().restarted.push_back(c);
        }
      }
      entered.push_back(result.size() - 1);
    }
    const automata::Ticks end = time.ticks(times[left_.back()]);
    if (end > result.back().time) {
      result.push_back({end, result.back().modes, automata::idle_action(situations_.plant())});
    }
    return witness;
  }

  std::vector<Leg> legs_;
  Situations& situations_;
  const Observer& observer_;
  bool progress_;
  Schedule schedule_;
  std::vector<Schedule::Point> entered_;    ///< per state
  std::vector<Schedule::Point> left_;       ///< per state
  std::vector<Schedule::Point> restarted_;  ///< per component: when its clock was 0 last
  Schedule::Point stopwatch_ = 0;           ///< when it was 0
};

}  // namespace

TimedPath earliest_path(const std::vector<PathState>& path, PlantSystem& system) {
  return Timetable(itinerary(path, system), system).path();
}

Witness earliest_witness(const std::vector<PathState>& path, PlantSystem& system) {
  return earliest_path(path, system).witness;
}

}  // namespace rmpl::verifier
