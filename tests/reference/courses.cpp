// Every state of a plant, and every command in it.
// SPDX-License-Identifier: MIT
#include "tests/reference/courses.hpp"

#include <algorithm>

#include "tests/reference/goals.hpp"

namespace rmpl::reference {

using automata::ControlAction;
using automata::Modes;
using automata::Transition;

Courses::Courses(const Step& step) : step_(step), actions_(all_actions(step.plant())) {
  for (Modes& modes : all_states(step.plant()))
    if (step.possible(modes)) states_.push_back(std::move(modes));
  for (std::size_t s = 0; s < states_.size(); ++s) numbers_[states_[s]] = s;
  for (std::size_t c = 0; c < step.plant().components.size(); ++c)
    for (const Transition& t : step.plant().components[c].transitions) component_of_[&t] = c;
  const auto idle = std::find(actions_.begin(), actions_.end(), automata::idle_action(step.plant()));
  idle_ = static_cast<std::size_t>(std::distance(actions_.begin(), idle));
}

const Courses::Move& Courses::known(std::size_t state, std::size_t action) {
  const auto [at, fresh] = moves_.try_emplace({state, action});
  Move& move = at->second;
  if (!fresh) return move;
  const Modes& modes = states_[state];
  move.tolerated = step_.models().consistent(assumptions_of(step_.plant(), modes, actions_[action]));
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const automata::Component& component = step_.plant().components[c];
    for (const Transition& t : component.transitions)
      if (t.from == modes[c] && !component.is_fault(t) && can_be_taken(t) && step_.enabled(t, modes, actions_[action]))
        move.enabled.insert(&t);
  }
  for (const Modes& next : nominal_successors(step_, modes, actions_[action])) {
    move.after.insert(numbers_.at(next));
    if (is_one_by_one(move, modes, next)) move.one_by_one.insert(numbers_.at(next));
  }
  return move;
}

/// While something is left by what needs no time, no time passes, though chance may have it stay.
bool Courses::is_one_by_one(const Move& move, const Modes& from, const Modes& to) const {
  std::set<std::size_t> at_once;
  for (const Transition* t : move.enabled)
    if (!t->timing && t->from != t->to) at_once.insert(component_of_.at(t));
  std::size_t timed = 0;
  for (std::size_t c = 0; c < from.size(); ++c) timed += to[c] != from[c] && !at_once.contains(c) ? 1 : 0;
  return timed <= (at_once.empty() ? 1u : 0u);
}

std::size_t Courses::rest(std::size_t state) {
  const auto [at, fresh] = rest_.try_emplace(state, idle_);
  if (!fresh || tolerates(state, idle_)) return at->second;
  const auto cost = [&](std::size_t action) {
    std::size_t off_idle = 0;
    for (std::size_t i = 0; i < actions_[idle_].size(); ++i) off_idle += actions_[action][i] != actions_[idle_][i];
    const auto& now = enabled(state, action);
    const bool changes =
        std::any_of(now.begin(), now.end(), [](const Transition* t) { return !t->timing && t->from != t->to; });
    return std::pair(changes, off_idle);
  };
  for (std::size_t a = 0; a < actions_.size(); ++a)
    if (tolerates(state, a) && (!tolerates(state, at->second) || cost(a) < cost(at->second))) at->second = a;
  return at->second;
}

const std::set<std::size_t>& Courses::by_itself(std::size_t state) {
  const auto [at, fresh] = by_itself_.try_emplace(state);
  std::set<std::size_t>& reached = at->second;
  if (!fresh) return reached;
  std::vector<std::size_t> open{state};
  reached.insert(state);
  while (!open.empty()) {
    const std::size_t from = open.back();
    open.pop_back();
    if (!tolerates(from, rest(from))) continue;
    for (const std::size_t next : one_by_one(from, rest(from)))
      if (reached.insert(next).second) open.push_back(next);
  }
  return reached;
}

bool Courses::is_held_back(std::size_t state) {
  for (const std::size_t later : by_itself(state))
    for (const Transition* t : enabled(later, rest(later))) {
      const auto& outcomes = one_by_one(later, rest(later));
      const std::size_t c = component_of_.at(t);
      if (std::none_of(outcomes.begin(), outcomes.end(), [&](std::size_t next) { return states_[next][c] == t->to; }))
        return true;
    }
  return false;
}

/// Whether at most one component leaves its mode at once.
bool Courses::others_rest(std::size_t state, std::size_t action) {
  std::set<std::size_t> leave;
  for (const Transition* t : enabled(state, action))
    if (!t->timing && t->from != t->to) leave.insert(component_of_.at(t));
  return leave.size() < 2;
}

bool Courses::is_one_command(std::size_t state, std::size_t action) {
  const ControlAction& whole = actions_[action];
  const ControlAction& idle = actions_[idle_];
  std::vector<std::size_t> parts;
  for (std::size_t a = 0; a < actions_.size(); ++a) {
    bool is_part = a != action && tolerates(state, a);
    for (std::size_t i = 0; i < whole.size(); ++i)
      is_part = is_part && (actions_[a][i] == whole[i] || actions_[a][i] == idle[i]);
    if (is_part) parts.push_back(a);
  }
  if (parts.empty() || (!tolerates(state, idle_) && others_rest(state, action))) return true;
  // Some component may do what it may do by no part of it.
  const auto of = [&](std::size_t c, std::size_t a) {
    std::set<const Transition*> result = enabled(state, a);
    std::erase_if(result, [&](const Transition* t) { return component_of_.at(t) != c; });
    return result;
  };
  for (std::size_t c = 0; c < step_.plant().components.size(); ++c)
    if (std::none_of(parts.begin(), parts.end(), [&](std::size_t part) { return of(c, part) == of(c, action); }))
      return true;
  return false;
}

}  // namespace rmpl::reference
