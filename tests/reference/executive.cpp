// The executive, by the letter of semantics 5.
// SPDX-License-Identifier: MIT
#include "tests/reference/executive.hpp"

#include <algorithm>
#include <optional>

namespace rmpl::reference {

using automata::Assignment;
using automata::Modes;
using automata::Transition;

const std::set<Advice>& Executive::allowed(const Modes& modes, const Goal& goal) {
  const std::size_t state = courses_.number(modes);
  const auto [at, fresh] = allowed_.try_emplace({state, goal});
  std::set<Advice>& result = at->second;
  if (!fresh) return result;
  if (goal.empty()) return result = {advice(courses_.rest(state), false)};
  Plans& plans = plans_of(goal);
  const Advice rest = advice(courses_.rest(state), false);
  result = plans.is_met(state) ? std::set{rest} : needed(state, plans, goal);
  // Housekeeping, where nothing is needed, or what is needed can wait.
  if (!result.contains(rest)) return result;
  for (std::size_t a = 0; a < courses_.actions().size(); ++a)
    if (result.contains(advice(a, false)) || is_housekeeping(state, a, plans, goal)) result.insert(advice(a, true));
  return result;
}

Advice Executive::advice(std::size_t action, bool for_reward) const {
  return {false, courses_.actions()[action], for_reward && action != courses_.idle()};
}

std::set<Advice> Executive::needed(std::size_t state, Plans& plans, const Goal& goal) {
  std::set<Advice> result;
  if (!plans.soberly(state)) result.insert({true, courses_.actions()[courses_.rest(state)], false});
  std::optional<std::size_t> bound;
  const bool compares = lasts(courses_.step().plant(), automata::conjunction_of(goal)) && !waits_are_unsafe(state);
  if (compares) bound = plans.surely(state);
  for (std::size_t a = 0; a < courses_.actions().size(); ++a) {
    if (!plans.is_choice(state, a)) continue;
    const bool rests = a == courses_.rest(state);
    const auto leads = [&](std::size_t next) {
      const auto left = plans.hoped(next);
      return left && (!bound || *left < *bound || (rests && moves_at_once(state) && *left == *bound));
    };
    const auto& outcomes = courses_.after(state, a);
    const bool on_the_way = std::any_of(outcomes.begin(), outcomes.end(), leads);
    // A wait before the step that cannot be taken.
    const bool in_vain = rests && !plans.hoped(state) && plans.boldly(state);
    if (on_the_way || in_vain) result.insert(advice(a, false));
  }
  const Goal first = put_off(state, goal);
  if (first != goal && plans.is_possible() && !plans_of(first).is_met(state)) {
    for (const Advice& then : allowed(courses_.states()[state], first))
      if (!then.no_plan) result.insert(then);
  }
  return result;
}

Executive::Goal Executive::put_off(std::size_t state, const Goal& goal) {
  Goal result;
  for (const Assignment& part : goal) {
    bool always = true;
    for (std::size_t s = 0; s < courses_.states().size(); ++s)
      always = always && (!has(s, part) || is_lost_at_once(s, part));
    if (!always && !(has(state, part) && is_lost_at_once(state, part))) result.push_back(part);
  }
  return result;
}

bool Executive::is_lost_at_once(std::size_t state, const Assignment& part) {
  const auto& outcomes = courses_.after(state, courses_.rest(state));
  return std::none_of(outcomes.begin(), outcomes.end(), [&](std::size_t next) { return has(next, part); });
}

bool Executive::moves_at_once(std::size_t state) {
  const auto& enabled = courses_.enabled(state, courses_.rest(state));
  return std::any_of(enabled.begin(), enabled.end(),
                     [](const Transition* t) { return !t->timing && t->from != t->to; });
}

bool Executive::waits_are_unsafe(std::size_t state) {
  const auto& components = courses_.step().plant().components;
  const auto& later = courses_.by_itself(state);
  const auto is_unsafe = [&](std::size_t s, std::size_t a) {
    const auto& enabled = courses_.enabled(s, a);
    const auto leaves = [&](const Transition& t) { return t.timing && t.from != t.to && enabled.contains(&t); };
    return courses_.tolerates(s, a) &&
           std::count_if(components.begin(), components.end(), [&](const automata::Component& component) {
             return std::any_of(component.transitions.begin(), component.transitions.end(), leaves);
           }) > 1;
  };
  for (const std::size_t s : later)
    for (std::size_t a = 0; a < courses_.actions().size(); ++a)
      if (is_unsafe(s, a)) return true;
  return false;
}

bool Executive::is_housekeeping(std::size_t state, std::size_t action, Plans& plans, const Goal& goal) {
  if (action == courses_.idle() || !keeps(state, action, plans, goal)) return false;
  const auto& comes = courses_.enabled(state, courses_.rest(state));
  const auto& enabled = courses_.enabled(state, action);
  const bool holds_back = std::includes(comes.begin(), comes.end(), enabled.begin(), enabled.end());
  if (holds_back && !plans.is_met(state)) return true;
  std::set<std::size_t> seen = courses_.after(state, action);
  std::vector<std::size_t> open(seen.begin(), seen.end());
  while (!open.empty()) {
    const std::size_t from = open.back();
    open.pop_back();
    if (is_worth_more(from, state)) return true;
    for (std::size_t a = 0; a < courses_.actions().size(); ++a)
      if (keeps(from, a, plans, goal))
        for (const std::size_t next : courses_.after(from, a))
          if (seen.insert(next).second) open.push_back(next);
  }
  return false;
}

bool Executive::keeps(std::size_t state, std::size_t action, Plans& plans, const Goal& goal) {
  if (!plans.is_choice(state, action)) return false;
  const std::size_t rest = courses_.rest(state);
  if (action == rest || !courses_.is_plain(state)) return true;
  const auto some = [&](std::size_t a, const auto& condition) {
    const auto& outcomes = courses_.after(state, a);
    return std::any_of(outcomes.begin(), outcomes.end(), condition);
  };
  for (const Assignment& part : goal) {
    const auto lacks = [&](std::size_t next) { return !has(next, part); };
    if (has(state, part) && some(action, lacks) && !some(rest, lacks)) return false;
  }
  const auto hopeless = [&](std::size_t next) { return !plans.hoped(next); };
  return plans.is_met(state) || !some(action, hopeless) || some(rest, hopeless);
}

bool Executive::has(std::size_t state, const Assignment& part) const {
  const auto store = assumptions_of(courses_.step().plant(), courses_.states()[state]);
  return std::find(store.begin(), store.end(), part) != store.end();
}

/// Whether some component is.
bool Executive::is_worth_more(std::size_t state, std::size_t than) const {
  const auto& components = courses_.step().plant().components;
  for (std::size_t c = 0; c < components.size(); ++c) {
    const auto reward = [&](std::size_t s) { return components[c].modes[courses_.states()[s][c].index()].reward; };
    if (reward(state) > reward(than)) return true;
  }
  return false;
}

Plans& Executive::plans_of(const Goal& goal) {
  const auto at = plans_.find(goal);
  if (at != plans_.end()) return at->second;
  return plans_.emplace(goal, Plans(courses_, automata::conjunction_of(goal))).first->second;
}

}  // namespace rmpl::reference
