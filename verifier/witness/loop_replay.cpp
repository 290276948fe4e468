// Replaying a run of the closed loop on the rules.
// SPDX-License-Identifier: MIT
#include "verifier/witness/loop_replay.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "verifier/witness/known.hpp"
#include "verifier/witness/plant_run.hpp"
#include "verifier/witness/steps_at.hpp"

namespace rmpl::verifier {

using automata::Component;
using automata::ControlAction;
using automata::Marking;
using automata::Modes;
using automata::Ticks;

namespace {

using Readings = std::vector<std::optional<Ticks>>;

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
  LoopReplay(const automata::Program& program, automata::PlainStep& rules, automata::ProgramStep& sequencer,
             runtime::Reconfigurer& planner, const Witness& witness, const ReplayRules& replay_rules)
      : plant_(rules, replay_rules.period),
        planner_(planner),
        witness_(witness),
        rules_(replay_rules),
        constants_(constants_of(program)),
        sequencer_(sequencer),
        started_(program.clocks.size()),
        renewed_(program.clocks.size()) {}

  std::optional<std::string> run() {
    if (auto failure = plant_.start(witness_.events.front().modes, rules_.from)) return failure;
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
    begin_as(last, last.time);
    if (goals_ != last.cycle->goals || left_out_ != last.cycle->left_out || action_ != last.action)
      return "another goal" + at(last.time);
    if (conflict_ == last.cycle->conflicts.empty()) return "no such conflict" + at(last.time);
    if (outcome_ != last.cycle->outcome) return "another plan" + at(last.time);
    if (witness_.waits_for_ever) {
      if (auto failure = wait(last.time, settled(last.time))) return failure;
    }
    if (witness_.repeats_from && !witness_.stop && !takes_time()) return "it goes round in no time" + at(last.time);
    if (witness_.stop && !witness_.stop->still && !is_stuck()) return "something can follow" + at(last.time);
    if (witness_.stop && witness_.stop->still && !stands_still_) return "time passes" + at(last.time);
    if (faults_in(plant(), witness_) > rules_.faults) return "it has more faults than the budget";
    return std::nullopt;
  }

 private:
  [[nodiscard]] const automata::Plant& plant() const { return plant_.plant(); }
  [[nodiscard]] const Modes& modes() const { return plant_.state().modes; }

  /// Whether time passes as it goes round.
  [[nodiscard]] bool takes_time() const {
    const std::vector<Event>& events = witness_.events;
    return events[*witness_.repeats_from - 1].time < events[events.size() - 2].time;
  }

  /// What the sequencer knows in these modes, which the cycle before led to.
  [[nodiscard]] automata::Knowledge knowledge(const Modes& modes) {
    automata::Knowledge result{automata::assignments_of(plant(), modes)};
    for (const automata::Formula& atom : sequencer_.asked())
      result.answers.push_back(is_known_after(plant_.rules().store(), atom, modes, before_ ? &*before_ : nullptr));
    return result;
  }

  /// The first half of a cycle; leaves what it says in `goals_`, `conflict_`, `outcome_` and `action_`.
  void begin(Ticks now, const Readings& seen) {
    Readings starts = started_;
    for (std::size_t c = 0; c < starts.size(); ++c) {
      if (seen[c]) starts[c] = now - *seen[c];
    }
    sequencer_.resume(marking_, starts);
    const automata::Asserted& asserted = sequencer_.begin(knowledge(modes()), now);
    conflict_ = !asserted.conflicts.empty();
    const std::vector<automata::Goals> goals = conflict_ ? std::vector<automata::Goals>() : runtime::goals_of(asserted);
    pursued_ = runtime::pursue(planner_, {&modes(), 1}, goals, position_);
    goals_ = pursued_.goals;
    left_out_ = pursued_.left_out;
    outcome_ = pursued_.answer.outcome;
    purpose_ = pursued_.answer.why.purpose;
    action_ = pursued_.answer.action;
  }

  /// The first half of the cycle of an event. In dense time the marking may go round at this instant, so that a clock
  /// that is forgotten in one round runs in the next: the event is in the one of two rounds that says what it tells.
  void begin_as(const Event& event, Ticks now) {
    const Cycle& cycle = *event.cycle;
    begin(now, cycle.readings);
    if (rules_.period || (goals_ == cycle.goals && conflict_ != cycle.conflicts.empty() && action_ == event.action))
      return;
    const Marking marking = marking_;
    const Readings started = started_;
    const auto answered = before_;
    const runtime::StrategyPosition position = position_;
    const automata::SystemState plant = plant_.state();
    anew_.assign(modes().size(), false);
    const bool comes_again = !go_round(now, now) && reads(cycle);
    if (!comes_again) plant_.come_back(plant);
    if (!comes_again) std::tie(marking_, started_, before_, position_) = std::tie(marking, started, answered, position);
    begin(now, cycle.readings);
  }

  /// The second half, with the plant in `modes`.
  void finish(Ticks now, const Modes& modes) {
    before_ = Answered{pursued_.goals, pursued_.answer.outcome, pursued_.left_out};
    position_ = runtime::position_after(pursued_.answer, modes);
    sequencer_.finish(knowledge(modes));
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
    anew_.assign(modes().size(), false);
    if (!reads(cycle) && !rules_.period) {
      // Cycles that go round have started clocks anew at this instant.
      if (auto failure = go_round(cycle.begin, cycle.begin)) return failure;
    }
    if (!reads(cycle)) return "a clock reads otherwise" + at(cycle.begin);
    begin_as(event, cycle.begin);
    if (goals_ != cycle.goals || left_out_ != cycle.left_out || conflict_ == cycle.conflicts.empty())
      return "another goal" + at(cycle.begin);
    if (action_ != event.action || outcome_ != cycle.outcome) return "another command" + at(cycle.begin);
    if (purpose_ != cycle.why.purpose) return "another purpose" + at(cycle.begin);
    if (event.time != cycle.begin + rules_.period.value_or(Ticks{0}))
      return "a cycle of another length" + at(cycle.begin);
    if (rules_.period && cycle.begin.count % rules_.period->count != 0)
      return "it is not on the period" + at(cycle.begin);
    if (round_ && !rules_.period) {
      stands_still_ =
          stands_still_ || !StepsAt(plant_.rules(), plant_.state(), cycle.begin, std::nullopt).time_passes(action_);
    }
    const bool possible =
        plant_.rules().possible(event.modes) && plant_.may_step(action_, cycle.begin, event.time, event.modes);
    if (!possible) return "the step is not possible" + at(event.time);
    if (plant_.tells_too_much(event)) return "no such clock starts anew" + at(event.time);
    finish(cycle.begin, event.modes);
    if (marking_ != cycle.next) return "another marking" + at(event.time);
    plant_.advance(action_, event.modes, event.time);
    return std::nullopt;
  }

  /// Whether the clocks read what the cycle sees.
  [[nodiscard]] bool reads(const Cycle& cycle) const {
    const Readings now = real(cycle.begin);
    // In dense time a cycle at a constant may be one just before or just after it, and so may that have been which
    // started the clock.
    const Ticks slack{rules_.period ? 0 : 2};
    for (std::size_t c = 0; c < now.size(); ++c) {
      if (!cycle.readings[c]) continue;
      if (!now[c] || *cycle.readings[c] > *now[c] + slack || *cycle.readings[c] + slack < *now[c]) return false;
    }
    return true;
  }

  /// Whether nothing follows under the last command, no fault either, and in dense time no time passes.
  bool is_stuck() {
    const Ticks now = witness_.events.back().time + rules_.period.value_or(Ticks{0});
    StepsAt steps(plant_.rules(), plant_.state(), now, rules_.period, &action_);
    if (steps.fault_is_certain(action_)) return false;
    if (!rules_.period && steps.time_passes(action_)) return false;
    return !steps.any(action_, [](const Modes&) { return true; });
  }

  /// As a cycle of a wait sees them. In dense time one that was started at the same instant reads a little more than 0.
  [[nodiscard]] Readings seen(Ticks now) const {
    Readings result = real(now);
    for (auto& reading : result) {
      if (reading && !rules_.period) reading = std::max(*reading, Ticks{1});
    }
    return result;
  }

  /// Cycles in which nothing changes, or, in dense time, in which the marking goes round.
  std::optional<std::string> wait(Ticks from, Ticks to) {
    if (to < from) return "time runs backwards" + at(to);
    renewed_.assign(started_.size(), 0);
    anew_.assign(modes().size(), false);
    std::set<Ticks> begins = telling(from, to);
    if (begins.empty() && from < to && plant_.has_restarts()) begins.insert(from);
    for (const Ticks now : begins) {
      // What each round starts anew was started by the one before, which is not looked at.
      plant_.restart(anew_, now);
      if (auto failure = go_round(now, to)) return failure;
    }
    plant_.restart(anew_, to);
    return std::nullopt;
  }

  /// One round of these cycles, in a wait that lasts up to a time. A clock that each round forgets or starts anew was,
  /// if it runs, started just before, in the rounds that are not looked at.
  std::optional<std::string> go_round(Ticks now, Ticks to) {
    for (std::size_t c = 0; c < started_.size(); ++c) {
      if (renewed_[c] >= 2 && started_[c]) started_[c] = std::max(*started_[c], now - Ticks{1});
    }
    if (plant_.has_restarts() && !rules_.period) note_restarts(now);
    const Marking before = marking_;
    const Readings started_before = started_;
    std::set<std::pair<Marking, Readings>> met;  // a clock may be forgotten, or started anew, in one marking of a round
    do {
      if (!met.insert({marking_, started_}).second) return "waiting leads elsewhere" + at(now);
      begin(now, seen(now));
      const bool stays = rules_.period
                             ? plant_.may_step(action_, now, now + *rules_.period, modes())
                             : plant_.may_step(action_, now, now, modes()) && plant_.may_wait(action_, now, to, anew_);
      if (!stays) return "nothing changing is not possible" + at(now);
      const std::vector<bool> anew = plant_.restarted(action_);
      note_anew(anew);
      plant_.restart(anew, now);
      finish(now, modes());
      if (rules_.period && marking_ != before) return "waiting changes the marking" + at(now);
    } while (marking_ != before);
    for (std::size_t c = 0; c < started_.size(); ++c) {
      renewed_[c] = started_[c] != started_before[c] ? renewed_[c] + 1 : 0;
    }
    return std::nullopt;
  }

  void note_anew(const std::vector<bool>& anew) {
    for (std::size_t c = 0; c < anew.size(); ++c) anew_[c] = anew_[c] || anew[c];
  }

  /// In dense time: the components whose clocks some cycle of the round starts anew.
  void note_restarts(Ticks now) {
    const Marking marking = marking_;
    const Readings started = started_;
    const auto answered = before_;
    const runtime::StrategyPosition position = position_;
    std::set<Marking> met;
    while (met.insert(marking_).second) {
      begin(now, seen(now));
      note_anew(plant_.restarted(action_));
      finish(now, modes());
    }
    std::tie(marking_, started_, before_, position_) = std::tie(marking, started, answered, position);
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
    for (const auto& start : started_) {
      if (!start) continue;
      for (const Ticks constant : constants_) {
        if (constant <= to) look_around(*start + constant);
      }
    }
    for (const Ticks met : plant_.meets_bounds(to)) look_around(met);
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

  PlantRun plant_;
  runtime::Reconfigurer& planner_;
  const Witness& witness_;
  const ReplayRules& rules_;
  std::vector<Ticks> constants_;
  automata::ProgramStep& sequencer_;
  Marking marking_;
  Readings started_;
  std::vector<bool> anew_;              ///< by component: a restart has started its clock anew in the wait
  std::vector<std::size_t> renewed_;    ///< by clock: rounds of the wait, up to the last one, that forgot or started it
  bool round_ = false;                  ///< the cycle at hand is one of those that go round
  bool stands_still_ = false;           ///< no time passes in one of them
  std::optional<Answered> before_;      ///< by the cycle that led to the state at hand
  runtime::StrategyPosition position_;  ///< that it led to
  // What the first half of the last cycle said:
  runtime::Pursued pursued_;
  automata::Goals goals_;
  std::vector<runtime::LeftOut> left_out_;
  bool conflict_ = false;
  runtime::Reconfiguration::Outcome outcome_ = runtime::Reconfiguration::Outcome::nothing_to_do;
  runtime::Reason::Purpose purpose_ = runtime::Reason::Purpose::none;
  ControlAction action_;
};

}  // namespace

LoopJudge::LoopJudge(const automata::Program& program, const automata::Plant& plant,
                     std::shared_ptr<const runtime::NominalGraph> graph, Ticks cycle)
    : program_(program),
      rules_(plant),
      asked_(plant),
      planner_(runtime::make_reconfigurer(asked_, std::move(graph), cycle)),
      sequencer_(program, plant) {}

std::optional<std::string> LoopJudge::replay(const Witness& witness, const ReplayRules& replay_rules) {
  sequencer_.reset();
  return LoopReplay(program_, rules_, sequencer_, *planner_, witness, replay_rules).run();
}

}  // namespace rmpl::verifier
