// Goal states and plans by looking at all of them.
// SPDX-License-Identifier: MIT
#include "tests/reference/goals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rmpl::reference {

using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::Transition;

bool can_be_taken(const Transition& t) { return t.weight.kind == automata::Weight::Kind::none || t.weight.value > 0; }

std::vector<ControlAction> all_actions(const automata::Plant& plant) {
  std::vector<std::size_t> sizes;
  for (const automata::Control& control : plant.controls)
    sizes.push_back(plant.variables[control.variable].values.size());
  std::vector<ControlAction> result;
  for (const auto& tuple : tuples(sizes)) {
    ControlAction& action = result.emplace_back();
    for (std::size_t value : tuple) action.emplace_back(value);
  }
  return result;
}

bool is_single(const automata::Plant& plant, const ControlAction& action) {
  std::size_t off_idle = 0;
  for (std::size_t i = 0; i < action.size(); ++i) off_idle += action[i] != plant.controls[i].idle;
  return off_idle <= 1;
}

std::vector<Modes> all_states(const automata::Plant& plant) {
  std::vector<std::size_t> sizes;
  for (const automata::Component& component : plant.components) sizes.push_back(component.modes.size());
  std::vector<Modes> result;
  for (const auto& tuple : tuples(sizes)) {
    Modes& modes = result.emplace_back();
    for (std::size_t mode : tuple) modes.emplace_back(mode);
  }
  return result;
}

namespace {

bool can_be_brought_about(const Step& step, std::size_t component, const Transition& t) {
  for (const Modes& modes : all_states(step.plant())) {
    if (modes[component] != t.from || !step.possible(modes)) continue;
    for (const ControlAction& action : all_actions(step.plant()))
      if (step.models().consistent(assumptions_of(step.plant(), modes, action)) && step.enabled(t, modes, action))
        return true;
  }
  return false;
}

/// The nominal transitions of a component that can happen at all.
std::vector<const Transition*> nominal_transitions(const Step& step, std::size_t component) {
  const automata::Component& automaton = step.plant().components[component];
  std::vector<const Transition*> result;
  for (const Transition& t : automaton.transitions)
    if (!automaton.is_fault(t) && can_be_taken(t) && can_be_brought_about(step, component, t)) result.push_back(&t);
  return result;
}

template <class Usable>
std::set<ModeId> closure(const std::vector<const Transition*>& transitions, ModeId from, const Usable& usable) {
  std::set<ModeId> reached = {from};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const Transition* t : transitions)
      if (reached.contains(t->from) && usable(*t)) reached.insert(t->to);
  }
  return reached;
}

void collect(const automata::Plant& plant, std::size_t component, const automata::Formula& goal, int negations,
             std::set<ModeId>& found) {
  using Kind = automata::Formula::Kind;
  if (goal.kind == Kind::member && goal.variable == plant.components[component].mode && negations % 2 == 0) {
    const std::size_t modes = plant.components[component].modes.size();
    if (modes > 2 && goal.values.size() == modes - 1) return;
    for (const automata::ValueId v : goal.values) found.insert(ModeId(v.index()));
  }
  if (goal.kind == Kind::equivalence) return;
  for (std::size_t i = 0; i < goal.operands.size(); ++i) {
    const bool negates = goal.kind == Kind::negation || (goal.kind == Kind::implication && i == 0);
    collect(plant, component, goal.operands[i], negations + (negates ? 1 : 0), found);
  }
}

/// The modes that a component comes to from where it may start, as it is meant to, by such transitions.
template <class Usable>
std::set<ModeId> usual_modes(const automata::Component& automaton, const std::vector<const Transition*>& transitions,
                             const Usable& usable) {
  std::set<ModeId> result;
  for (std::size_t m = 0; m < automaton.modes.size(); ++m)
    if (automaton.initial[m] > 0 && !automaton.modes[m].fault) result.merge(closure(transitions, ModeId(m), usable));
  return result;
}

/// The modes that it ever comes to, faults or not.
std::set<ModeId> all_modes(const automata::Component& automaton) {
  std::vector<const Transition*> transitions;
  for (const Transition& t : automaton.transitions) transitions.push_back(&t);
  std::set<ModeId> result;
  for (std::size_t m = 0; m < automaton.modes.size(); ++m)
    if (automaton.initial[m] > 0) result.merge(closure(transitions, ModeId(m), [](const Transition&) { return true; }));
  return result;
}

}  // namespace

std::set<ModeId> named_modes(const automata::Plant& plant, std::size_t component, const automata::Formula& goal) {
  std::set<ModeId> found;
  collect(plant, component, goal, 0, found);
  return found;
}

bool is_forbidden(const Step& step, std::size_t component, const Transition& t, const automata::Formula& goal) {
  const automata::Component& automaton = step.plant().components[component];
  if (automaton.is_fault(t) || automaton.modes[t.from.index()].fault || !can_be_taken(t)) return false;
  const auto transitions = nominal_transitions(step, component);
  const auto further = closure(transitions, t.to, [](const Transition&) { return true; });
  if (further.contains(t.from)) return false;
  const auto usual = usual_modes(automaton, transitions, [](const Transition&) { return true; });
  const auto safe = usual_modes(automaton, transitions, [&](const Transition& u) {
    return closure(transitions, u.to, [](const Transition&) { return true; }).contains(u.from);
  });
  const bool by_faults = all_modes(automaton).contains(t.from) && !usual.contains(t.from);
  if (by_faults && (!usual.contains(t.to) || safe.contains(t.to))) return false;
  const std::set<ModeId> named = named_modes(step.plant(), component, goal);
  return std::none_of(named.begin(), named.end(), [&](ModeId m) { return further.contains(m); });
}

namespace {

/// Whether a component may go from one mode to another while all controls stay idle, now or later.
bool comes_at_rest(const Step& step, const Modes& start, std::size_t component, ModeId from, ModeId to) {
  const ControlAction idle = automata::idle_action(step.plant());
  std::set<Modes> seen{start};
  std::vector<Modes> open{start};
  while (!open.empty()) {
    const Modes modes = std::move(open.back());
    open.pop_back();
    for (const Modes& next : nominal_successors(step, modes, idle)) {
      if (modes[component] == from && next[component] == to) return true;
      if (seen.insert(next).second) open.push_back(next);
    }
  }
  return false;
}

}  // namespace

const Transition* forbidden_step(const Step& step, const Modes& modes, const ControlAction& action,
                                 const automata::Formula& goal) {
  const automata::Plant& plant = step.plant();
  const ControlAction idle = automata::idle_action(plant);
  if (!step.models().consistent(assumptions_of(plant, modes, idle))) return nullptr;
  if (nominal_successors(step, modes, idle).empty()) return nullptr;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    for (const Transition& t : plant.components[i].transitions) {
      if (t.from != modes[i] || !step.enabled(t, modes, action) || !is_forbidden(step, i, t, goal)) continue;
      const auto all = nominal_successors(step, modes, action);
      const bool comes = std::any_of(all.begin(), all.end(), [&](const Modes& next) { return next[i] == t.to; });
      if (comes && !comes_at_rest(step, modes, i, t.from, t.to)) return &t;
    }
  }
  return nullptr;
}

bool is_swayed(const Step& step, std::size_t component, ModeId mode) {
  const automata::Component& automaton = step.plant().components[component];
  std::set<std::set<const Transition*>> met;
  for (const Modes& modes : all_states(step.plant())) {
    if (modes[component] != mode || !step.possible(modes)) continue;
    for (const ControlAction& action : all_actions(step.plant())) {
      if (!step.models().consistent(assumptions_of(step.plant(), modes, action))) continue;
      std::set<const Transition*> now;
      for (const Transition& t : automaton.transitions)
        if (t.from == mode && !automaton.is_fault(t) && step.enabled(t, modes, action)) now.insert(&t);
      met.insert(std::move(now));
    }
  }
  return met.size() > 1;
}

double reward_of(const automata::Plant& plant, const Modes& modes) {
  double reward = 0;
  for (std::size_t i = 0; i < modes.size(); ++i) reward += plant.components[i].modes[modes[i].index()].reward;
  return reward;
}

namespace {

/// Per component, the modes that a nominal step may lead to.
std::vector<std::set<ModeId>> nominal_choices(const Step& step, const Modes& modes, const ControlAction& action) {
  std::vector<std::set<ModeId>> choices;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const automata::Component& automaton = step.plant().components[i];
    std::set<ModeId> untimed;
    std::set<ModeId> timed = {modes[i]};
    for (const Transition& t : automaton.transitions)
      if (t.from == modes[i] && !automaton.is_fault(t) && can_be_taken(t) && step.enabled(t, modes, action))
        (t.timing ? timed : untimed).insert(t.to);
    choices.push_back(untimed.empty() ? timed : untimed);
  }
  return choices;
}

}  // namespace

std::set<Modes> nominal_successors(const Step& step, const Modes& modes, const ControlAction& action) {
  std::vector<std::vector<ModeId>> options;
  std::vector<std::size_t> sizes;
  for (const auto& choices : nominal_choices(step, modes, action)) {
    options.emplace_back(choices.begin(), choices.end());
    sizes.push_back(choices.size());
  }
  std::set<Modes> result;
  for (const auto& tuple : tuples(sizes)) {
    Modes next;
    for (std::size_t i = 0; i < tuple.size(); ++i) next.push_back(options[i][tuple[i]]);
    if (step.possible(next)) result.insert(next);
  }
  return result;
}

namespace {

bool is_enough(const Step& step, const Modes& modes, const ControlAction& action, const automata::Formula& goal) {
  const automata::Plant& plant = step.plant();
  if (!step.models().consistent(assumptions_of(plant, modes, action))) return false;
  const ControlAction idle = automata::idle_action(plant);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const auto transitions = nominal_transitions(step, i);
    for (const Transition* t : transitions) {
      if (t->from != modes[i] || t->to == t->from || t->timing) continue;
      if (!step.enabled(*t, modes, action) || step.enabled(*t, modes, idle)) continue;
      if (is_forbidden(step, i, *t, goal)) return false;
    }
  }
  const auto choices = nominal_choices(step, modes, action);
  const auto& conjuncts = goal.kind == automata::Formula::Kind::conjunction ? goal.operands : std::vector{goal};
  for (const automata::Formula& conjunct : conjuncts)
    for (std::size_t i = 0; i < modes.size(); ++i)
      for (const ModeId mode : choices[i])
        if (conjunct.kind == automata::Formula::Kind::member && conjunct.variable == plant.components[i].mode &&
            std::find(conjunct.values.begin(), conjunct.values.end(), automata::ValueId(mode.index())) ==
                conjunct.values.end())
          return false;
  const auto successors = nominal_successors(step, modes, action);
  return !successors.empty() && std::all_of(successors.begin(), successors.end(), [&](const Modes& next) {
    return step.models().entails(assumptions_of(plant, next), goal);
  });
}

}  // namespace

std::optional<ControlAction> cheapest_action(const Step& step, const std::vector<Modes>& states,
                                             const automata::Formula& goal) {
  const auto cost = [&](const ControlAction& action) {
    std::size_t off_idle = 0;
    for (std::size_t i = 0; i < action.size(); ++i) off_idle += action[i] != step.plant().controls[i].idle ? 1 : 0;
    return off_idle;
  };
  std::optional<ControlAction> best;
  for (const ControlAction& action : all_actions(step.plant())) {
    if (best && cost(action) >= cost(*best)) continue;
    const bool enough =
        std::all_of(states.begin(), states.end(), [&](const Modes& s) { return is_enough(step, s, action, goal); });
    if (enough) best = action;
  }
  return best;
}

std::set<Modes> nominal_outcomes(const Step& step, const Modes& modes, const std::vector<ControlAction>& commands) {
  std::set<Modes> states = {modes};
  for (const ControlAction& command : commands) {
    std::set<Modes> next;
    for (const Modes& state : states) next.merge(nominal_successors(step, state, command));
    states = std::move(next);
  }
  return states;
}

namespace {

/// Whether all controls can be idle, and nothing happens nominally while they are.
bool stable(const Step& step, const Modes& modes) {
  ControlAction idle;
  for (const automata::Control& control : step.plant().controls) idle.push_back(control.idle);
  return step.models().consistent(assumptions_of(step.plant(), modes, idle)) &&
         nominal_successors(step, modes, idle) == std::set<Modes>{modes};
}

/// Whether every component that changes can come back by nominal transitions.
bool reversible(const Step& step, const Modes& from, const Modes& to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] == to[i]) continue;
    const auto back = closure(nominal_transitions(step, i), to[i], [](const Transition&) { return true; });
    if (!back.contains(from[i])) return false;
  }
  return true;
}

}  // namespace

namespace {

/// The states that single, certain, reversible commands reach, with how many it takes, nearest first; a state that does
/// not satisfy `goes_on` is reached and not left.
template <class GoesOn>
std::vector<std::pair<Modes, std::size_t>> reached(const Step& step, const Modes& from, const GoesOn& goes_on) {
  std::vector<std::pair<Modes, std::size_t>> found;
  if (!stable(step, from)) return found;
  std::set<Modes> seen = {from};
  found.emplace_back(from, 0);
  for (std::size_t next = 0; next < found.size(); ++next) {
    const auto [state, count] = found[next];
    if (!goes_on(state)) continue;
    for (const ControlAction& action : all_actions(step.plant())) {
      if (!is_single(step.plant(), action)) continue;
      if (!step.models().consistent(assumptions_of(step.plant(), state, action))) continue;
      const auto choices = nominal_choices(step, state, action);
      const std::set<Modes> successors = nominal_successors(step, state, action);
      if (successors.empty() || std::any_of(choices.begin(), choices.end(), [](auto& c) { return c.size() > 1; }))
        continue;
      if (!stable(step, *successors.begin())) continue;
      if (!reversible(step, state, *successors.begin())) continue;
      if (seen.insert(*successors.begin()).second) found.emplace_back(*successors.begin(), count + 1);
    }
  }
  return found;
}

}  // namespace

bool is_better(const automata::Plant& plant, const Modes& from, const Modes& left, const Modes& right) {
  const auto changed = [&](const Modes& modes) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < from.size(); ++i) count += modes[i] != from[i] ? 1 : 0;
    return count;
  };
  const double more = reward_of(plant, left) - reward_of(plant, right);
  constexpr double rounding = 1e-9;
  if (std::abs(more) > rounding) return more > 0;
  return changed(left) < changed(right);
}

static bool is_met(const Step& step, const Modes& state, const automata::Formula& goal) {
  return step.models().entails(assumptions_of(step.plant(), state), goal);
}

Modes best_kept(const Step& step, const Modes& modes, const automata::Formula& goal) {
  Modes best = modes;
  const auto entails = [&](const Modes& state) { return is_met(step, state, goal); };
  for (const auto& [state, count] : reached(step, modes, entails))
    if (entails(state) && is_better(step.plant(), modes, state, best)) best = state;
  return best;
}

std::optional<std::size_t> fewest_commands(const Step& step, const Modes& modes, const automata::Formula& goal) {
  const auto entails = [&](const Modes& state) { return is_met(step, state, goal); };
  for (const auto& [state, count] : reached(step, modes, [&](const Modes& s) { return !entails(s); }))
    if (entails(state)) return count;
  return std::nullopt;
}

std::optional<std::size_t> fewest_commands_alone(const Step& step, const Modes& modes, automata::ComponentId component,
                                                 const automata::Formula& goal) {
  const auto entails = [&](const Modes& state) { return is_met(step, state, goal); };
  const auto rests = [&](Modes state) {
    state[component.index()] = modes[component.index()];
    return state == modes;
  };
  for (const auto& [state, count] : reached(step, modes, [&](const Modes& s) { return rests(s) && !entails(s); }))
    if (rests(state) && entails(state)) return count;
  return std::nullopt;
}

}  // namespace rmpl::reference
