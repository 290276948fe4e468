// Timetables: concrete times for a symbolic path of the closed loop.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/timetable.hpp"

#include <algorithm>
#include <array>

#include "base/check.hpp"
#include "verifier/zone/schedule.hpp"

namespace rmpl::verifier {

using automata::ClockId;
using automata::Ticks;

namespace {

/// The points in time of one path: for each state when it is entered, and when the next cycle after waiting begins.
class LoopTimetable {
 public:
  LoopTimetable(const std::vector<PathState>& path, Loop& loop, const Query& query, const std::optional<PathEnd>& end)
      : path_(path), loop_(loop), query_(query), end_(end), started_(loop.program().clocks.size()) {}

  Witness witness() {
    restarted_.assign(state(0).modes.size(), 0);
    entered_.push_back(0);
    stay(0);
    for (std::size_t i = 1; i < path_.size(); ++i) step(i);
    return events(solve());
  }

 private:
  [[nodiscard]] LoopStateId id(std::size_t i) const { return ProgramSystem::loop_state(path_[i].discrete); }
  [[nodiscard]] const LoopState& state(std::size_t i) const { return loop_[id(i)]; }
  /// Outcomes with fewer faults come first: no more are worked out than it takes.
  [[nodiscard]] Outcome outcome(std::size_t i) const {
    const std::uint32_t move = path_[i].label.move;
    for (unsigned faults = 0;; ++faults) {
      CHECK(faults <= loop_.faults());
      const auto turn = loop_.turn(id(i - 1), faults);
      if (move < turn->outcomes.size()) return turn->outcomes[move];
    }
  }

  void step(std::size_t i) {
    const Schedule::Point begin = left_.back();
    const Schedule::Point end = schedule_.add_point();
    schedule_.fix(begin, end, loop_.time().is_dense() ? 0 : 1);
    const Box bounds = outcome(i).bounds;
    for (const ClockBound& b : bounds) schedule_.constrain(restarted(b), end, b.clock);
    if (query_.progress && loop_.time().is_dense()) {
      const bool progressed = ProgramSystem::progressed(path_[i].discrete);
      schedule_.constrain(progress_, end, progressed ? Interval{loop_.time().grain(), unbounded} : Interval{0, 0});
      if (progressed) progress_ = end;
    }
    for (std::size_t c = 0; c < restarted_.size(); ++c) {
      if (state(i).modes[c] != state(i - 1).modes[c]) restarted_[c] = end;
    }
    const std::shared_ptr<const Turn> turn = loop_.turn(id(i - 1));
    for (const automata::ComponentId c : turn->anew) restarted_[c.index()] = end;
    entered_.push_back(end);
    mark_started(i, begin);
    stay(i);
  }

  /// Clocks that are active in state i and were not before have started with the cycle that led there.
  void mark_started(std::size_t i, Schedule::Point begin) {
    for_each_clock(i, [&](ClockId clock, const Cell&) {
      bool before = false;
      for_each_clock(i - 1, [&](ClockId known, const Cell&) { before = before || known == clock; });
      if (!before) started_[clock.index()] = begin;
    });
  }

  /// Clocks that the rounds of a wait start anew: at its end they have just been started.
  void mark_restarted(std::size_t i) {
    if (path_[i].label.wait == ProgramSystem::no_wait) return;
    const std::shared_ptr<const Turn> turn = loop_.turn(id(i));
    const Wait& wait = turn->waits[path_[i].label.wait];
    for (const std::size_t g : wait.restarted) {
      for (const ClockId clock : state(i).groups[g].clocks) started_[clock.index()] = left_[i];
    }
    for (const ClockId clock : wait.restarted_passed) started_[clock.index()] = left_[i];
  }

  template <class Visit>
  void for_each_clock(std::size_t i, const Visit& visit) const {
    const ClockCells& cells = loop_.cells();
    for (const ClockId clock : state(i).passed) {
      visit(clock, cells.around(std::array{clock}, static_cast<std::uint32_t>(2 * cells.constants().size())));
    }
    for (const ClockGroup& group : state(i).groups) {
      for (const ClockId clock : group.clocks) visit(clock, loop_.cell(group));
    }
  }

  void stay(std::size_t i) {
    const Schedule::Point left = schedule_.add_point();
    if (path_[i].label.wait == ProgramSystem::no_wait) {
      schedule_.fix(entered_.back(), left, 0);
    } else {
      const std::shared_ptr<const Turn> turn = loop_.turn(id(i));
      const Wait& wait = turn->waits[path_[i].label.wait];
      schedule_.constrain(entered_.back(), left, {wait.anew.empty() ? 0 : 1, unbounded});
      for (const ClockBound& b : wait.bounds) {
        if (std::binary_search(wait.anew.begin(), wait.anew.end(), b.component)) {
          schedule_.constrain(restarted(b), entered_.back(), b.clock);
          continue;
        }
        schedule_.constrain(restarted(b), entered_.back(), {b.clock.lower, unbounded});
        schedule_.constrain(restarted(b), left, {0, b.clock.upper});
      }
      for (const automata::ComponentId c : wait.anew) restarted_[c.index()] = left;
    }
    left_.push_back(left);
    mark_restarted(i);
    if (end_ && end_->position == i) {
      for (const ClockBound& b : end_->components) schedule_.constrain(restarted(b), left, b.clock);
      for (const auto& reading : end_->program) {
        schedule_.constrain(started_[reading.first.index()], left, reading.second);
      }
    }
    for_each_clock(i, [&](ClockId clock, const Cell& cell) {
      const Interval readings = loop_.cells().units(cell, loop_.time());
      if (started_[clock.index()] == left) return;
      schedule_.constrain(started_[clock.index()], entered_.back(), {readings.lower, unbounded});
      schedule_.constrain(started_[clock.index()], left, {0, readings.upper});
    });
  }

  [[nodiscard]] std::vector<Units> solve() {
    const Schedule::Point last = left_.back();
    if (query_.window && !end_) schedule_.constrain(0, last, *query_.window);
    if (end_ && end_->stopwatch) schedule_.constrain(entered_[asked()], last, *end_->stopwatch);
    const bool awaits = query_.aim == Query::Aim::late || query_.aim == Query::Aim::missed;
    if (awaits && query_.deadline != unbounded && !end_) {
      Schedule late = schedule_;
      late.constrain(entered_[asked()], last, {query_.deadline, unbounded});
      // What comes true on the way does so too late.
      for (std::size_t i = asked(); i < path_.size(); ++i) {
        if (query_.test(state(i))) late.constrain(entered_[asked()], entered_[i], {query_.deadline, unbounded});
      }
      return times_of(late);
    }
    const bool waits = query_.aim == Query::Aim::endless_wait || (awaits && !query_.progress);
    if (!waits || end_) return times_of(schedule_);
    const std::shared_ptr<const Turn> turn = loop_.turn(id(path_.size() - 1));
    for (const Wait& wait : turn->waits) {
      if (!wait.endless) continue;
      Schedule waiting = schedule_;
      for (const Box* box : {&wait.bounds, &wait.settled}) {
        for (const ClockBound& b : *box) waiting.constrain(restarted(b), last, b.clock);
      }
      if (auto times = waiting.solve()) return *times;
    }
    throw base::InternalError("an accepted state cannot wait for ever");
  }

  /// The state from which on what does not come is owed.
  [[nodiscard]] std::size_t asked() const {
    if (query_.aim == Query::Aim::late) return 0;
    const auto first = std::find_if(path_.begin(), path_.end(),
                                    [](const PathState& state) { return ProgramSystem::owed(state.discrete); });
    return static_cast<std::size_t>(first - path_.begin());
  }

  static std::vector<Units> times_of(const Schedule& schedule) {
    auto times = schedule.solve();
    CHECK(times && "a path that the search found has no times");
    return *times;
  }

  [[nodiscard]] Schedule::Point restarted(const ClockBound& bound) const { return restarted_[bound.component.index()]; }

  [[nodiscard]] Witness events(const std::vector<Units>& times) {
    Witness result;
    result.events.push_back({Ticks{0}, state(0).modes, automata::idle_action(loop_.plant())});
    // `started_` grew along the path; what a cycle saw is asked again, cycle by cycle.
    started_.assign(started_.size(), 0);
    for (std::size_t i = 0; i < path_.size(); ++i) {
      if (i > 0) mark_started(i, left_[i - 1]);
      mark_restarted(i);
      Event event = begun(i, times);
      if (i + 1 < path_.size()) {
        event.time = loop_.time().ticks(times[entered_[i + 1]]);
        event.modes = state(i + 1).modes;
        event.cycle->next = state(i + 1).marking;
        const std::shared_ptr<const Turn> turn = loop_.turn(id(i));
        for (const automata::ComponentId c : turn->anew) {
          if (state(i).modes[c.index()] == event.modes[c.index()]) event.restarted.push_back(c);
        }
      }
      result.events.push_back(std::move(event));
    }
    return result;
  }

  [[nodiscard]] Event begun(std::size_t i, const std::vector<Units>& times) const {
    const std::shared_ptr<const Turn> worked = loop_.turn(id(i));
    const Turn& turn = *worked;
    Cycle cycle;
    cycle.begin = loop_.time().ticks(times[left_[i]]);
    cycle.marking = cycle.next = state(i).marking;
    cycle.readings.resize(started_.size());
    for_each_clock(i, [&](ClockId clock, const Cell& cell) {
      const Ticks real = cycle.begin - loop_.time().ticks(times[started_[clock.index()]]);
      cycle.readings[clock.index()] = loop_.cells().nearest(cell, real);
    });
    cycle.goals = turn.goals;
    cycle.left_out = turn.left_out;
    cycle.conflicts = turn.conflicts;
    cycle.outcome = turn.answer.outcome;
    cycle.why = turn.answer.why;
    cycle.reason = turn.answer.reason;
    const Ticks begin = cycle.begin;
    return {begin, state(i).modes, turn.action, std::move(cycle)};
  }

  const std::vector<PathState>& path_;
  Loop& loop_;
  const Query& query_;
  const std::optional<PathEnd>& end_;
  Schedule schedule_;
  std::vector<Schedule::Point> entered_;    ///< per state
  std::vector<Schedule::Point> left_;       ///< per state
  std::vector<Schedule::Point> restarted_;  ///< per component: when its clock was 0 last
  std::vector<Schedule::Point> started_;    ///< per program clock, where it is active
  Schedule::Point progress_ = 0;            ///< when the clock of progress was 0 last
};

}  // namespace

Witness earliest_witness(const std::vector<PathState>& path, Loop& loop, const Query& query,
                         const std::optional<PathEnd>& end) {
  return LoopTimetable(path, loop, query, end).witness();
}

}  // namespace rmpl::verifier
