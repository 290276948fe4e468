// Replaying a trace of the closed loop on the step functions.
// SPDX-License-Identifier: MIT
#include "verifier/witness/loop_replay.hpp"

#include <algorithm>
#include <set>

#include "verifier/witness/rules.hpp"
#include "verifier/witness/start.hpp"
#include "verifier/witness/steps_at.hpp"

namespace rmpl::verifier {

using automata::Component;
using automata::ControlAction;
using automata::Marking;
using automata::Modes;
using automata::Ticks;

namespace {

using Readings = std::vector<std::optional<Ticks>>;

std::string at(Ticks time) { return " at " + automata::format_seconds(time) + " s"; }

void add_constants(const automata::Formula& formula, std::vector<Ticks>& constants) {
  if (formula.kind == automata::Formula::Kind::clock && !formula.bound.is_infinite())
    constants.push_back(formula.bound);
  for (const automata::Formula& operand : formula.operands) add_constants(operand, constants);
}

/// The finite times that a program compares clocks with.
std::vector<Ticks> constants_of(const automata::Program& program) {
  std::vector<Ticks> constants;
  for (const automata::Location& location : program.locations) {
    add_constants(location.maintenance.constraint, constants);
    for (const automata::Arc& arc : location.arcs) add_constants(arc.guard.constraint, constants);
  }
  std::sort(constants.begin(), constants.end());
  constants.erase(std::unique(constants.begin(), constants.end()), constants.end());
  return constants;
}

class LoopReplay {
 public:
  LoopReplay(const automata::Program& program, automata::PlantStep& step, runtime::Reconfigurer& reconfigurer,
             const Witness& witness, const ReplayRules& rules)
      : step_(step),
        reconfigurer_(reconfigurer),
        witness_(witness),
        rules_(rules),
        constants_(constants_of(program)),
        sequencer_(program, step.plant()),
        started_(program.clocks.size()) {}

  std::optional<std::string> run() {
    if (auto failure = start()) return failure;
    marking_ = sequencer_.marking();
    Ticks now{0};
    const std::vector<Event>& events = witness_.events;
    for (std::size_t e = 1; e + 1 < events.size(); ++e) {
      if (auto failure = wait(now, events[e].cycle->begin)) return failure;
      round_ = witness_.repeats_from && *witness_.repeats_from <= e;
      if (auto failure = run(events[e])) return failure;
      now = events[e].time;
    }
    const Event& last = events.back();
    if (auto failure = wait(now, last.time)) return failure;
    if (marking_ != last.cycle->marking) return "another marking" + at(last.time);
    begin(last.time, last.cycle->readings);
    if (goal_ != last.cycle->goal || action_ != last.action) return "another goal" + at(last.time);
    if (conflict_ == last.cycle->conflicts.empty()) return "no such conflict" + at(last.time);
    if (outcome_ != last.cycle->outcome) return "another plan" + at(last.time);
    if (rules_.endless) {
      if (auto failure = wait(last.time, settled(last.time))) return failure;
    }
    if (witness_.stop && !witness_.stop->still && !is_stuck()) return "something can follow" + at(last.time);
    if (witness_.stop && witness_.stop->still && !stands_still_) return "time passes" + at(last.time);
    if (faults_in(plant(), witness_) > rules_.faults) return "it has more faults than the budget";
    return std::nullopt;
  }

 private:
  [[nodiscard]] const automata::Plant& plant() const { return step_.plant(); }

  std::optional<std::string> start() {
    const Modes& modes = witness_.events.front().modes;
    if (auto failure = wrong_start(step_, modes, rules_.from)) return failure;
    state_ = {modes, std::vector<Ticks>(modes.size(), Ticks{0})};
    return std::nullopt;
  }

  /// The first half of a cycle; leaves what it says in `goal_`, `conflict_`, `outcome_` and `action_`.
  void begin(Ticks now, const Readings& seen) {
    Readings starts = started_;
    for (std::size_t c = 0; c < starts.size(); ++c) {
      if (seen[c]) starts[c] = now - *seen[c];
    }
    sequencer_.resume(marking_, starts);
    const automata::Asserted& asserted = sequencer_.begin({automata::assignments_of(plant(), state_.modes)}, now);
    conflict_ = !asserted.conflicts.empty();
    goal_ = conflict_ ? std::vector<automata::Assignment>{} : asserted.goal;
    const auto answer = reconfigurer_.next(state_.modes, automata::conjunction_of(goal_));
    outcome_ = answer.outcome;
    action_ = outcome_ == runtime::Reconfiguration::Outcome::command ? answer.action : automata::idle_action(plant());
  }

  /// The second half, with the plant in `modes`.
  void finish(Ticks now, const Modes& modes) {
    sequencer_.finish({automata::assignments_of(plant(), modes)});
    marking_ = sequencer_.marking();
    for (std::size_t c = 0; c < started_.size(); ++c) {
      const bool runs = sequencer_.started()[c].has_value();
      if (!runs) started_[c].reset();
      if (runs && !started_[c]) started_[c] = now;
    }
  }

  /// The readings of all clocks, as they are.
  [[nodiscard]] Readings real(Ticks now) const {
    Readings result(started_.size());
    for (std::size_t c = 0; c < started_.size(); ++c) {
      if (started_[c]) result[c] = now - *started_[c];
    }
    return result;
  }

  std::optional<std::string> run(const Event& event) {
    const Cycle& cycle = *event.cycle;
    if (cycle.marking != marking_) return "another marking" + at(cycle.begin);
    const Readings now = real(cycle.begin);
    // In dense time a cycle at a constant may be one just before or just after it.
    const Ticks slack{rules_.period ? 0 : 1};
    for (std::size_t c = 0; c < now.size(); ++c) {
      if (!cycle.readings[c]) continue;
      if (!now[c] || *cycle.readings[c] > *now[c] + slack || *cycle.readings[c] + slack < *now[c]) {
        return "a clock reads otherwise" + at(cycle.begin);
      }
    }
    begin(cycle.begin, cycle.readings);
    if (goal_ != cycle.goal || conflict_ == cycle.conflicts.empty()) return "another goal" + at(cycle.begin);
    if (action_ != event.action || outcome_ != cycle.outcome) return "another command" + at(cycle.begin);
    if (event.time != cycle.begin + rules_.period.value_or(Ticks{0}))
      return "a cycle of another length" + at(cycle.begin);
    if (rules_.period && cycle.begin.count % rules_.period->count != 0)
      return "it is not on the period" + at(cycle.begin);
    if (round_ && !rules_.period) {
      stands_still_ = stands_still_ || !StepsAt(step_, state_, cycle.begin, std::nullopt).time_passes(action_);
    }
    if (!possible(cycle.begin, event.time, event.modes)) return "the step is not possible" + at(event.time);
    finish(cycle.begin, event.modes);
    if (marking_ != cycle.next) return "another marking" + at(event.time);
    state_ = automata::PlantStep::advance(state_, event.modes, event.time);
    return std::nullopt;
  }

  bool possible(Ticks before, Ticks now, const Modes& next) {
    if (!step_.possible(next)) return false;
    const auto& enabled = step_.enabled(state_.modes, action_);
    for (std::size_t c = 0; c < enabled.size(); ++c) {
      const Ticks start = state_.clock_starts[c];
      const Rules rules(plant().components[c], enabled[c], before - start, now - start, rules_.period);
      if (!rules.allows(state_.modes[c], next[c])) return false;
    }
    return !rules_.period || step_.leads(state_, action_, before, now, next);
  }

  /// Whether no step follows under the last command, and in dense time no time passes.
  bool is_stuck() {
    const Ticks now = witness_.events.back().time + rules_.period.value_or(Ticks{0});
    StepsAt steps(step_, state_, now, rules_.period);
    if (!rules_.period && steps.time_passes(action_)) return false;
    return !steps.any(action_, [](const Modes&) { return true; });
  }

  bool time_may_pass_up_to(Ticks now) {
    const auto& enabled = step_.enabled(state_.modes, action_);
    for (std::size_t c = 0; c < enabled.size(); ++c) {
      const Ticks clock = now - state_.clock_starts[c];
      if (!Rules(plant().components[c], enabled[c], clock, clock, std::nullopt).allows_time(state_.modes[c]))
        return false;
    }
    return true;
  }

  /// Cycles in which nothing changes, or, in dense time, in which the marking goes round.
  std::optional<std::string> wait(Ticks from, Ticks to) {
    if (to < from) return "time runs backwards" + at(to);
    for (const Ticks now : telling(from, to)) {
      const Marking before = marking_;
      std::set<Marking> seen;
      do {
        if (!seen.insert(marking_).second) return "waiting leads elsewhere" + at(now);
        begin(now, real(now));
        const bool stays = rules_.period ? possible(now, now + *rules_.period, state_.modes)
                                         : possible(now, now, state_.modes) && time_may_pass_up_to(to);
        if (!stays) return "nothing changing is not possible" + at(now);
        finish(now, state_.modes);
        if (rules_.period && marking_ != before) return "waiting changes the marking" + at(now);
      } while (marking_ != before);
    }
    return std::nullopt;
  }

  /// The begins of those cycles from `from` on, and before `to`, that tell of all: the first, the last, and those in
  /// which a clock is near where its reading matters. In dense time the ends themselves are seen by the cycles there.
  [[nodiscard]] std::set<Ticks> telling(Ticks from, Ticks to) const {
    std::set<Ticks> result;
    const Ticks near = rules_.period.value_or(Ticks{1});
    const auto look = [&](Ticks begin) {
      const bool inside = rules_.period ? from <= begin && begin + near <= to : from < begin && begin < to;
      if (inside) result.insert(begin);
    };
    const auto look_around = [&](Ticks met) {
      const Ticks begin{met.count / near.count * near.count};
      for (int i = -2; i <= 2; ++i) look(begin + Ticks{near.count * i});
    };
    look(from);
    look_around(from);
    look_around(to);
    const auto meets = [&](Ticks start, Ticks bound) {
      if (!bound.is_infinite() && bound <= to) look_around(start + bound);
    };
    for (const auto& start : started_) {
      if (!start) continue;
      for (const Ticks constant : constants_) meets(*start, constant);
    }
    for (std::size_t c = 0; c < state_.modes.size(); ++c) {
      for (const automata::Transition& t : plant().components[c].transitions) {
        if (t.from != state_.modes[c] || !t.timing) continue;
        meets(state_.clock_starts[c], t.timing->lower);
        meets(state_.clock_starts[c], t.timing->upper);
      }
    }
    return result;
  }

  /// A time from which on no clock meets a constant or a finite bound any more.
  [[nodiscard]] Ticks settled(Ticks now) const {
    Ticks longest{0};
    const auto add = [&](Ticks time) {
      if (!time.is_infinite()) longest = std::max(longest, time);
    };
    for (const Ticks constant : constants_) add(constant);
    for (const Component& component : plant().components) {
      for (const automata::Transition& t : component.transitions) {
        if (!t.timing) continue;
        add(t.timing->lower);
        add(t.timing->upper);
      }
    }
    const Ticks cycle = rules_.period.value_or(Ticks{1});
    return now + Ticks{(longest.count / cycle.count + 3) * cycle.count};
  }

  automata::PlantStep& step_;
  runtime::Reconfigurer& reconfigurer_;
  const Witness& witness_;
  const ReplayRules& rules_;
  std::vector<Ticks> constants_;
  automata::ProgramStep sequencer_;
  automata::SystemState state_;
  Marking marking_;
  Readings started_;
  bool round_ = false;         ///< the cycle at hand is one of those that go round
  bool stands_still_ = false;  ///< no time passes in one of them
  // What the first half of the last cycle said:
  std::vector<automata::Assignment> goal_;
  bool conflict_ = false;
  runtime::Reconfiguration::Outcome outcome_ = runtime::Reconfiguration::Outcome::nothing_to_do;
  ControlAction action_;
};

}  // namespace

std::optional<std::string> replay(const automata::Program& program, automata::PlantStep& step,
                                  runtime::Reconfigurer& reconfigurer, const Witness& witness,
                                  const ReplayRules& rules) {
  return LoopReplay(program, step, reconfigurer, witness, rules).run();
}

}  // namespace rmpl::verifier
