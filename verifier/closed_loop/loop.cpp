// The closed loop of a program, a plant and the reconfigurer.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/loop.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "verifier/behaviour/exits.hpp"
#include "verifier/property/initial_modes.hpp"
#include "verifier/property/known_truth.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::ClockId;
using automata::ComponentId;
using automata::Formula;
using automata::ModeId;
using automata::Modes;
using automata::Ticks;

namespace {

/// Twice so many at most are kept.
constexpr std::size_t turns_remembered = 1u << 13;

}  // namespace

Loop::Loop(const automata::Program& program, automata::PlantStep& step, runtime::Reconfigurer& reconfigurer,
           const TimeModel& time, unsigned faults, Meter& meter, const std::vector<automata::Formula>& asked)
    : program_(program),
      step_(step),
      reconfigurer_(reconfigurer),
      time_(time),
      faults_(faults),
      meter_(meter),
      cells_(program),
      sequencer_(program, step.plant()),
      explored_turns_(turns_remembered) {
  std::vector<Formula> atoms = sequencer_.asked();
  for (const Formula& formula : asked) collect_knowledge(formula, atoms);
  for (Formula& atom : atoms) {
    if (atom.knowing == automata::Knowing::no_plan) no_plan_asked_.push_back(std::move(atom));
  }
}

std::vector<LoopState> Loop::initial(const std::vector<Assignment>& from) {
  sequencer_.reset();
  std::vector<LoopState> result;
  base::for_each_combination(initial_modes(plant(), from), [&](const Modes& modes) {
    meter_.poll();
    if (step_.possible(modes))
      result.push_back({sequencer_.marking(), modes, {}, {}, std::vector<bool>(no_plan_asked_.size())});
  });
  return result;
}

LoopStateId Loop::number(const LoopState& state) {
  const auto [at, fresh] = numbers_.try_emplace(state, states_.size());
  if (fresh) states_.push_back(&at->first);
  return at->second;
}

std::vector<ComponentId> Loop::live(const Modes& modes) const {
  std::vector<ComponentId> result;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (plant().has_timed_exit(ComponentId(c), modes[c])) result.emplace_back(c);
  }
  return result;
}

std::shared_ptr<const Turn> Loop::turn(LoopStateId id, unsigned faults) {
  const std::shared_ptr<Worked> worked = cycle(id, faults);
  if (!worked->waits) {
    worked->turn.waits = waits(id);
    worked->waits = true;
  }
  return {worked, &worked->turn};
}

std::vector<Outcome> Loop::outcomes(LoopStateId id, const std::vector<Modes>& modes) {
  const LoopState& state = *states_[id.index()];
  const std::shared_ptr<const Worked> worked = cycle(id);
  sequencer_.resume(state.marking, started(state));
  sequencer_.begin(knowledge(state.modes, state.no_plan), Ticks{0});
  std::vector<Outcome> result;
  result.reserve(modes.size());
  for (const Modes& next : modes) {
    meter_.poll();
    sequencer_.finish(knowledge(next, worked->turn.no_plan));
    result.push_back(follow(state, next, worked->turn));
  }
  return result;
}

std::shared_ptr<Loop::Worked> Loop::known(LoopStateId id) {
  if (const auto open = turns_.find(id); open != turns_.end()) return open->second;
  const auto* explored = explored_turns_.find(id);
  return explored != nullptr ? *explored : nullptr;
}

std::shared_ptr<Loop::Worked> Loop::cycle(LoopStateId id, unsigned faults) {
  std::shared_ptr<Worked> worked = known(id);
  if (!worked) {
    worked = std::make_shared<Worked>(Worked{work_out(*states_[id.index()], faults), faults, false});
    turns_.emplace(id, worked);
  } else if (worked->faults < faults) {
    worked->turn.outcomes = work_out(*states_[id.index()], faults).outcomes;
    worked->faults = faults;
  }
  return worked;
}

bool Loop::may_rest(LoopStateId id) {
  const LoopState& state = *states_[id.index()];
  const automata::AllEnabled enabled = step_.enabled(state.modes, cycle(id)->turn.action);
  for (std::size_t c = 0; c < state.modes.size(); ++c) {
    if (verifier::waits(plant().components[c], state.modes[c], enabled[c], time_).empty()) return false;
  }
  return true;
}

void Loop::explored(LoopStateId id) {
  const auto known = turns_.find(id);
  if (known == turns_.end()) return;
  explored_turns_.add(id, std::move(known->second));
  turns_.erase(known);
}

std::vector<std::optional<Ticks>> Loop::started(const LoopState& state) const {
  std::vector<std::optional<Ticks>> result(program_.clocks.size());
  const auto reads = [&](ClockId clock, const Cell& cell) {
    result[clock.index()] = Ticks{0} - cells_.nearest(cell, Ticks{0});
  };
  for (const ClockId clock : state.passed) {
    const auto top = static_cast<std::uint32_t>(2 * cells_.constants().size());
    reads(clock, {top, top});
  }
  for (const ClockGroup& group : state.groups) {
    for (const ClockId clock : group.clocks) reads(clock, cell(group));
  }
  return result;
}

std::vector<Choice> Loop::choices_of(const LoopState& state, const Turn& turn, ComponentId component) {
  const auto& enabled = step_.enabled(state.modes, turn.action);
  return choices(plant()[component], state.modes[component.index()], enabled[component.index()], time_);
}

bool Loop::is_known(const Formula& atom, const std::vector<Assignment>& modes, const std::vector<bool>& no_plan) {
  automata::Theory& theory = step_.theory();
  return verifier::is_known(
      atom, [&](const Formula& formula) { return theory.entails(modes, theory.encode(formula)); },
      [&](const Formula& formula) { return theory.allows(modes, theory.encode(formula)); },
      [&](const Formula& asked) {
        const auto at = std::find(no_plan_asked_.begin(), no_plan_asked_.end(), asked);
        return no_plan[static_cast<std::size_t>(at - no_plan_asked_.begin())];
      });
}

automata::Knowledge Loop::knowledge(const Modes& modes, const std::vector<bool>& no_plan) {
  automata::Knowledge result{automata::assignments_of(plant(), modes)};
  for (const Formula& atom : sequencer_.asked()) {
    result.answers.push_back(is_known(atom, result.assignments, no_plan));
  }
  return result;
}

bool Loop::holds(const Formula& formula, const LoopState& state, bool certain) {
  const std::vector<Assignment> modes = automata::assignments_of(plant(), state.modes);
  const Formula known =
      with_knowledge(formula, [&](const Formula& atom) { return is_known(atom, modes, state.no_plan); });
  const automata::Theory::Handle handle = step_.theory().encode(known);
  return certain ? step_.theory().entails(modes, handle) : step_.theory().allows(modes, handle);
}

Turn Loop::work_out(const LoopState& state, unsigned faults) {
  Turn turn;
  sequencer_.resume(state.marking, started(state));
  const automata::Asserted& asserted = sequencer_.begin(knowledge(state.modes, state.no_plan), Ticks{0});
  turn.conflicts = asserted.conflicts;
  const std::vector<automata::Goals> goals =
      turn.conflicts.empty() ? runtime::goals_of(asserted) : std::vector<automata::Goals>();
  runtime::Pursued pursued = runtime::pursue(reconfigurer_, {&state.modes, 1}, goals, state.position);
  for (const Formula& atom : no_plan_asked_) {
    const auto component = atom.about_one ? plant().component_of(atom.variable) : std::nullopt;
    turn.no_plan.push_back(
        runtime::no_plan(pursued.goals, pursued.answer.outcome, pursued.left_out, component, plant()));
  }
  turn.goals = std::move(pursued.goals);
  turn.left_out = std::move(pursued.left_out);
  turn.answer = std::move(pursued.answer);
  turn.action = turn.answer.action;
  const std::vector<bool> restarted = step_.restarted(state.modes, turn.action);
  for (const ComponentId c : live(state.modes)) {
    if (restarted[c.index()]) turn.anew.push_back(c);
  }
  std::vector<std::vector<Choice>> all;
  for (std::size_t c = 0; c < state.modes.size(); ++c) {
    all.push_back(choices_of(state, turn, ComponentId(c)));
    for (const Interval& clock : without_nominal(all.back())) turn.faulty.push_back({ComponentId(c), clock});
    add_enabled(turn.exits, all.back(), state.modes[c]);
  }
  std::set<JointChoice> seen;
  for_each_joint(all, faults, [&](const JointChoice& joint) {
    const auto& [modes, cost, bounds] = joint;
    meter_.poll();
    if (!seen.insert(joint).second || !step_.possible(modes)) return;
    if (cost == 0) add_open(turn.exits, state.modes, modes, bounds, time_);
    sequencer_.finish(knowledge(modes, turn.no_plan));
    Outcome outcome = follow(state, modes, turn);
    outcome.faults = cost;
    outcome.bounds = bounds;
    outcome.same = outcome.state == state;
    turn.outcomes.push_back(std::move(outcome));
  });
  std::stable_sort(turn.outcomes.begin(), turn.outcomes.end(),
                   [](const Outcome& a, const Outcome& b) { return a.faults < b.faults; });
  return turn;
}

Outcome Loop::follow(const LoopState& state, const Modes& modes, const Turn& turn) const {
  Outcome result;
  result.state.no_plan = turn.no_plan;
  result.state.position = position_after(turn.answer, modes);
  result.state.marking = sequencer_.marking();
  result.state.modes = modes;
  std::vector<bool> live = cells_.live(result.state.marking);
  const auto& running = sequencer_.started();
  // A clock that belongs to what is entered has stopped.
  for (std::size_t c = 0; c < live.size(); ++c) live[c] = live[c] && running[c].has_value();
  std::vector<bool> known(live.size(), false);
  const auto keep = [&](ClockGroup group, std::size_t source) {
    std::erase_if(group.clocks, [&](ClockId clock) { return !live[clock.index()]; });
    if (group.clocks.empty()) return;
    const Cell now = cell(group);
    if (cells_.is_last(now)) {
      result.state.passed.insert(result.state.passed.end(), group.clocks.begin(), group.clocks.end());
      return;
    }
    group.position = now.first;
    result.state.groups.push_back(std::move(group));
    result.sources.push_back(source);
  };
  for (const ClockId clock : state.passed) {
    known[clock.index()] = true;
    if (live[clock.index()]) result.state.passed.push_back(clock);
  }
  for (std::size_t g = 0; g < state.groups.size(); ++g) {
    for (const ClockId clock : state.groups[g].clocks) known[clock.index()] = true;
    keep(state.groups[g], g + 1);
  }
  ClockGroup fresh{{}, cells_.start()};
  for (std::size_t c = 0; c < live.size(); ++c) {
    if (live[c] && !known[c]) fresh.clocks.emplace_back(c);
  }
  keep(std::move(fresh), 0);
  std::sort(result.state.passed.begin(), result.state.passed.end());
  return result;
}

Loop::Round Loop::round(LoopStateId id) {
  Round result;
  // For each group of the state at hand 1 + the position at the begin of the one that it is, or 0: it started since.
  std::vector<std::size_t> sources(states_[id.index()]->groups.size());
  std::iota(sources.begin(), sources.end(), std::size_t{1});
  for (LoopStateId at = id;;) {
    result.states.push_back(at);
    const LoopState& state = *states_[at.index()];
    const std::shared_ptr<const Worked> worked = cycle(at);
    const Turn& turn = worked->turn;
    const auto stays = std::find_if(turn.outcomes.begin(), turn.outcomes.end(),
                                    [&](const Outcome& o) { return o.faults == 0 && o.state.modes == state.modes; });
    if (stays == turn.outcomes.end() || (!stays->same && !time_.is_dense())) return {};
    std::vector<std::size_t> moved;
    for (const std::size_t source : stays->sources) moved.push_back(source == 0 ? 0 : sources[source - 1]);
    sources = std::move(moved);
    at = number(stays->state);
    if (at == id) break;
    if (std::find(result.states.begin(), result.states.end(), at) != result.states.end()) return {};
  }
  // One that has taken the place of another is started anew too, a round later.
  for (std::size_t g = 0; g < sources.size(); ++g) {
    if (sources[g] != g + 1) result.restarted.push_back(g);
  }
  // A clock stays passed for as long as it runs.
  for (const ClockId clock : states_[id.index()]->passed) {
    const bool runs_on = std::all_of(result.states.begin(), result.states.end(), [&](LoopStateId state) {
      const std::vector<ClockId>& passed = states_[state.index()]->passed;
      return std::binary_search(passed.begin(), passed.end(), clock);
    });
    if (!runs_on) result.restarted_passed.push_back(clock);
  }
  return result;
}

std::vector<Interval> Loop::stays(const std::vector<Choice>& choices, ModeId mode) const {
  if (!time_.is_dense()) return {Interval{}};
  std::vector<Interval> result;
  for (const Choice& choice : choices) {
    if (choice.faults == 0 && choice.mode == mode) result.push_back(choice.clock);
  }
  result = merged(std::move(result));
  for (Interval& stay : result) {
    if (stay.upper != unbounded) ++stay.upper;
  }
  return result;
}

/// When components can leave their modes no more that could up to some reading, in any cycle of a round.
Box Loop::settled_after(const std::vector<LoopStateId>& states, const std::vector<bool>& anew) {
  const Modes modes = states_[states.front().index()]->modes;
  std::map<ComponentId, Units> last;
  for (const LoopStateId at : states) {
    const std::shared_ptr<const Worked> worked = cycle(at);
    for (const Outcome& outcome : worked->turn.outcomes) {
      if (outcome.faults > 0) continue;
      for (const ClockBound& bound : outcome.bounds) {
        const std::size_t c = bound.component.index();
        if (outcome.state.modes[c] == modes[c] || bound.clock.upper == unbounded || anew[c]) continue;
        Units& known = last[bound.component];
        known = std::max(known, bound.clock.upper);
      }
    }
  }
  Box result;
  for (const auto& [component, upper] : last) result.push_back({component, {upper, unbounded}});
  return result;
}

/// Whether the component may leave its mode in the cycle, with its clock started anew just before.
bool Loop::leaves_anew(const Turn& turn, const Modes& modes, std::size_t component) const {
  const Units reading = time_.is_dense() ? 0 : 1;
  return std::any_of(turn.outcomes.begin(), turn.outcomes.end(), [&](const Outcome& outcome) {
    return outcome.faults == 0 && outcome.state.modes[component] != modes[component] &&
           std::none_of(outcome.bounds.begin(), outcome.bounds.end(), [&](const ClockBound& b) {
             return b.component == ComponentId(component) && !b.clock.contains(reading);
           });
  });
}

std::vector<Wait> Loop::waits(LoopStateId id) {
  const auto [states, restarted, restarted_passed] = round(id);
  if (states.empty()) return {};
  const LoopState& state = *states_[id.index()];
  std::vector<Wait> result(1);
  result.front().restarted = restarted;
  result.front().restarted_passed = restarted_passed;
  std::vector<bool> anew(state.modes.size(), false);
  for (const LoopStateId at : states) {
    const std::shared_ptr<const Worked> worked = cycle(at);
    for (const ComponentId c : worked->turn.anew) anew[c.index()] = true;
  }
  for (std::size_t c = 0; c < anew.size(); ++c) {
    if (anew[c]) result.front().anew.emplace_back(c);
  }
  bool restless = restarted.size() < state.groups.size();
  for (std::size_t c = 0; c < state.modes.size(); ++c) {
    std::vector<Interval> intervals(1);
    for (const LoopStateId at : states) {
      const std::shared_ptr<const Worked> worked = cycle(at);
      const Turn& turn = worked->turn;
      std::vector<Interval> both;
      const automata::AllEnabled enabled = step_.enabled(state.modes, turn.action);
      for (const Interval& wait : verifier::waits(plant().components[c], state.modes[c], enabled[c], time_)) {
        for (const Interval& stay : stays(choices_of(state, turn, ComponentId(c)), state.modes[c])) {
          for (const Interval& known : intervals) {
            const Interval common = intersection(intersection(wait, stay), known);
            if (!common.empty()) both.push_back(common);
          }
        }
      }
      intervals = std::move(both);
      restless = restless || (anew[c] ? leaves_anew(turn, state.modes, c) : !turn.exits.open[c].empty());
    }
    // Time passes from the second round on with its clock at 0: in sampled time a wait that begins there is a period.
    const auto stays_at_0 = [&](const Interval& interval) {
      return interval.lower == 0 && (interval.upper > 0 || !time_.is_dense());
    };
    if (anew[c] && std::none_of(intervals.begin(), intervals.end(), stays_at_0)) return {};
    std::vector<Wait> longer;
    for (const Wait& wait : result) {
      for (const Interval& interval : intervals) {
        longer.push_back(wait);
        if (!interval.is_trivial()) longer.back().bounds.push_back({ComponentId(c), interval});
      }
    }
    result = std::move(longer);
  }
  const Box settled = settled_after(states, anew);
  for (Wait& wait : result) {
    wait.settled = settled;
    wait.endless = !restless && std::all_of(wait.bounds.begin(), wait.bounds.end(), [&](const ClockBound& b) {
      return b.clock.upper == unbounded || anew[b.component.index()];
    });
  }
  return result;
}

}  // namespace rmpl::verifier
