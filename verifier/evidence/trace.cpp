// Timed traces.
// SPDX-License-Identifier: MIT
#include "verifier/evidence/trace.hpp"

#include <cassert>

#include "verifier/evidence/schedule.hpp"
#include "verifier/explore/plant_system.hpp"

namespace verifier {

using automata::ComponentId;

namespace {

/// The points in time of one path: for each state when it is entered and when the wait in it ends.
class Timetable {
 public:
  Timetable(const std::vector<PathState>& path, Situations& situations, const Observer& observer)
      : path_(path), situations_(situations), observer_(observer) {}

  Trace trace() {
    begin();
    for (std::size_t i = 1; i < path_.size(); ++i) step(i);
    accept();
    const auto times = schedule_.solve();
    assert(times && "a path that the search found has no times");
    return events(*times);
  }

 private:
  [[nodiscard]] SituationId situation(std::size_t i) const { return PlantSystem::situation_of(path_[i].discrete); }
  [[nodiscard]] Phase phase(std::size_t i) const { return PlantSystem::phase_of(path_[i].discrete); }
  [[nodiscard]] const Move& move(std::size_t i) const {
    return situations_.moves(situation(i - 1))[path_[i].label.move];
  }

  void begin() {
    restarted_.assign(situations_[situation(0)].modes.size(), 0);
    entered_.push_back(0);
    wait(0);
  }

  /// From the end of the wait in state i - 1 to the end of the wait in state i.
  void step(std::size_t i) {
    const Move& taken = move(i);
    const Schedule::Point left = left_.back();
    const Schedule::Point entered = schedule_.add_point();
    if (taken.hold) {
      pass(taken.bounds, left, entered);
    } else {
      schedule_.fix(left, entered, situations_.reading().is_dense() ? 0 : 1);
      for (const ClockBound& b : taken.bounds) schedule_.constrain(restarted(b), entered, b.clock);
    }
    entered_.push_back(entered);
    const auto& before = situations_[situation(i - 1)].modes;
    const auto& after = situations_[situation(i)].modes;
    for (std::size_t c = 0; c < after.size(); ++c) {
      if (after[c] != before[c]) restarted_[c] = entered;
    }
    if (observer_.timed(phase(i)) && !observer_.timed(phase(i - 1))) stopwatch_ = entered;
    wait(i);
  }

  void wait(std::size_t i) {
    const Schedule::Point left = schedule_.add_point();
    if (path_[i].label.wait == PlantSystem::no_wait) {
      schedule_.fix(entered_.back(), left, 0);
    } else {
      pass(situations_[situation(i)].waits[path_[i].label.wait], entered_.back(), left);
    }
    left_.push_back(left);
  }

  /// Time passes within a box of waits.
  void pass(const Box& box, Schedule::Point from, Schedule::Point to) {
    schedule_.constrain(from, to, {});
    for (const ClockBound& b : box) {
      schedule_.constrain(restarted(b), from, {b.clock.lower, unbounded});
      schedule_.constrain(restarted(b), to, {0, b.clock.upper});
    }
  }

  void accept() {
    if (observer_.timed(phase(path_.size() - 1))) schedule_.constrain(stopwatch_, left_.back(), *observer_.accepted());
  }

  [[nodiscard]] Schedule::Point restarted(const ClockBound& bound) const { return restarted_[bound.component.index()]; }

  [[nodiscard]] Trace events(const std::vector<Units>& times) const {
    const Reading& reading = situations_.reading();
    Trace result = {{automata::Ticks{0}, situations_[situation(0)].modes, automata::idle_action(situations_.plant())}};
    for (std::size_t i = 1; i < path_.size(); ++i) {
      const auto& modes = situations_[situation(i)].modes;
      const auto& action = situations_.action(move(i).action);
      // A hold is as many steps as it has periods.
      const Units first = move(i).hold ? times[left_[i - 1]] + 1 : times[entered_[i]];
      for (Units at = first; at <= times[entered_[i]]; ++at) result.push_back({reading.time(at), modes, action});
    }
    const automata::Ticks end = reading.time(times[left_.back()]);
    if (end > result.back().time) {
      result.push_back({end, result.back().modes, automata::idle_action(situations_.plant())});
    }
    return result;
  }

  const std::vector<PathState>& path_;
  Situations& situations_;
  const Observer& observer_;
  Schedule schedule_;
  std::vector<Schedule::Point> entered_;    ///< per state
  std::vector<Schedule::Point> left_;       ///< per state
  std::vector<Schedule::Point> restarted_;  ///< per component: when its clock was 0 last
  Schedule::Point stopwatch_ = 0;           ///< when it was 0
};

}  // namespace

Trace earliest_trace(const std::vector<PathState>& path, Situations& situations, const Observer& observer) {
  return Timetable(path, situations, observer).trace();
}

std::size_t faults_in(const automata::Plant& plant, const Trace& trace) {
  std::size_t faults = 0;
  for (std::size_t e = 1; e < trace.size(); ++e) {
    for (std::size_t c = 0; c < plant.components.size(); ++c) {
      const automata::ModeId mode = trace[e].modes[c];
      faults += mode != trace[e - 1].modes[c] && plant.components[c].modes[mode.index()].fault ? 1 : 0;
    }
  }
  return faults;
}

}  // namespace verifier
