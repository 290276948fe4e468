// Goal states and plans by looking at all of them.
// SPDX-License-Identifier: MIT
#include "tests/reference/goals.hpp"

#include <algorithm>
#include <deque>
#include <map>

namespace rmpl::reference {

using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::Transition;

namespace {

bool can_be_taken(const Transition& t) { return t.weight.kind == automata::Weight::Kind::none || t.weight.value > 0; }

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

bool names(const automata::Formula& goal, automata::VariableId variable, automata::ValueId value) {
  if (goal.kind == automata::Formula::Kind::negation) return false;
  if (goal.kind == automata::Formula::Kind::member && goal.variable == variable)
    return goal.values == std::vector{value};
  return std::any_of(goal.operands.begin(), goal.operands.end(),
                     [&](const automata::Formula& operand) { return names(operand, variable, value); });
}

}  // namespace

std::vector<std::set<ModeId>> reachable_modes(const Step& step, const Modes& modes, const automata::Formula& goal) {
  const automata::Plant& plant = step.plant();
  std::vector<Modes> possible = all_states(plant);
  std::erase_if(possible, [&](const Modes& state) { return !step.possible(state); });
  const std::vector<ControlAction> actions = all_actions(plant);
  std::vector<std::set<ModeId>> reached;
  for (const ModeId mode : modes) reached.push_back({mode});

  const auto in_reach = [&](std::size_t i, ModeId mode) { return reached[i].contains(mode); };
  const auto enables = [&](std::size_t i, const Transition& t, const Modes& state, const ControlAction& action) {
    return state[i] == t.from && step.models().consistent(assumptions_of(plant, state, action)) &&
           step.enabled(t, state, action);
  };
  // What is out of reach does not matter: whatever modes the components have that are not in reach, the guard is
  // implied.
  const auto supported = [&](std::size_t i, const Transition& t) {
    for (const Modes& state : possible) {
      for (const ControlAction& action : actions) {
        if (!enables(i, t, state, action)) continue;
        const bool firm = std::all_of(possible.begin(), possible.end(), [&](const Modes& other) {
          for (std::size_t j = 0; j < other.size(); ++j)
            if ((j == i || in_reach(j, state[j])) && other[j] != state[j]) return true;
          return !step.models().consistent(assumptions_of(plant, other, action)) || enables(i, t, other, action);
        });
        if (firm) return true;
      }
    }
    return false;
  };
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const automata::Component& automaton = plant.components[i];
      const auto transitions = nominal_transitions(step, i);
      for (const Transition* t : transitions) {
        if (!in_reach(i, t->from) || in_reach(i, t->to)) continue;
        const auto back = closure(transitions, t->to, [](const Transition&) { return true; });
        const bool repair = t->from == modes[i] && automaton.modes[t->from.index()].fault;
        const bool permitted = t->timing || back.contains(t->from) || repair ||
                               names(goal, automaton.mode, automata::ValueId(t->to.index()));
        if (!permitted || !supported(i, *t)) continue;
        reached[i].insert(t->to);
        grown = true;
      }
    }
  }
  return reached;
}

std::optional<GoalState> best_goal_state(const Step& step, const Modes& modes, const automata::Formula& goal) {
  const automata::Plant& plant = step.plant();
  const std::vector<std::set<ModeId>> reachable = reachable_modes(step, modes, goal);

  std::optional<GoalState> best;
  for (const Modes& candidate : all_states(plant)) {
    double reward = 0;
    bool reached = true;
    for (std::size_t i = 0; i < candidate.size(); ++i) {
      reached = reached && reachable[i].contains(candidate[i]);
      reward += plant.components[i].modes[candidate[i].index()].reward;
    }
    if (!reached || !step.possible(candidate)) continue;
    if (!step.models().entails(assumptions_of(plant, candidate), goal)) continue;
    if (!best || reward > best->reward) best = GoalState{candidate, reward};
  }
  return best;
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
    const automata::Component& automaton = plant.components[i];
    const auto transitions = nominal_transitions(step, i);
    for (const Transition* t : transitions) {
      if (t->from != modes[i] || t->to == t->from || t->timing) continue;
      if (!step.enabled(*t, modes, action) || step.enabled(*t, modes, idle)) continue;
      const auto back = closure(transitions, t->to, [](const Transition&) { return true; });
      const bool repair = automaton.modes[t->from.index()].fault;
      if (!back.contains(t->from) && !repair && !names(goal, automaton.mode, automata::ValueId(t->to.index())))
        return false;
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

bool is_single(const automata::Plant& plant, const ControlAction& action) {
  std::size_t off_idle = 0;
  for (std::size_t i = 0; i < action.size(); ++i) off_idle += action[i] != plant.controls[i].idle;
  return off_idle <= 1;
}

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

std::optional<std::vector<ControlAction>> shortest_reversible_plan(const Step& step, const Modes& from,
                                                                   const Modes& to) {
  if (!stable(step, from)) return std::nullopt;
  std::map<Modes, std::vector<ControlAction>> plans = {{from, {}}};
  std::deque<Modes> queue = {from};
  while (!queue.empty()) {
    const Modes state = queue.front();
    queue.pop_front();
    if (state == to) return plans[state];
    for (const ControlAction& action : all_actions(step.plant())) {
      if (!is_single(step.plant(), action)) continue;
      if (!step.models().consistent(assumptions_of(step.plant(), state, action))) continue;
      const auto choices = nominal_choices(step, state, action);
      const std::set<Modes> successors = nominal_successors(step, state, action);
      if (successors.empty() || std::any_of(choices.begin(), choices.end(), [](auto& c) { return c.size() > 1; }))
        continue;
      if (!stable(step, *successors.begin())) continue;
      if (!reversible(step, state, *successors.begin())) continue;
      const auto [place, is_new] = plans.try_emplace(*successors.begin(), plans[state]);
      if (!is_new) continue;
      place->second.push_back(action);
      queue.push_back(place->first);
    }
  }
  return std::nullopt;
}

}  // namespace rmpl::reference
