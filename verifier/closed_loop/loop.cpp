// The closed loop of a program, a plant and the reconfigurer.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/loop.hpp"

#include <algorithm>
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

}  // namespace rmpl::verifier
