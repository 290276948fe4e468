// Plans by looking at every state.
// SPDX-License-Identifier: MIT
#include "tests/reference/plans.hpp"

#include <algorithm>

#include "tests/reference/goals.hpp"

namespace rmpl::reference {

using automata::Modes;
using automata::Transition;

Plans::Plans(Courses& courses, const automata::Formula& goal) : courses_(courses) {
  const Step& step = courses.step();
  for (const Modes& modes : courses.states())
    met_.push_back(step.models().entails(assumptions_of(step.plant(), modes), goal));
  for (std::size_t c = 0; c < step.plant().components.size(); ++c)
    for (const Transition& t : step.plant().components[c].transitions)
      if (is_forbidden(step, c, t, goal)) forbidden_.emplace_back(c, &t);
}

Plans::Steps Plans::taken(std::size_t state, std::size_t action) {
  Steps result;
  for (const auto& [component, t] : forbidden_) {
    if (!courses_.enabled(state, action).contains(t)) continue;
    for (const std::size_t next : courses_.one_by_one(state, action))
      if (courses_.states()[next][component] == t->to) result.emplace(component, t->to);
  }
  return result;
}

const Plans::Steps& Plans::coming(std::size_t state) {
  const auto [at, fresh] = coming_.try_emplace(state);
  Steps& steps = at->second;
  if (fresh)
    for (const std::size_t later : courses_.by_itself(state))
      if (courses_.tolerates(later, courses_.idle())) steps.merge(taken(later, courses_.idle()));
  return steps;
}

bool Plans::permits(std::size_t state, std::size_t action) {
  if (!courses_.tolerates(state, action)) return false;
  if (!courses_.is_plain(state)) return true;
  const Steps& anyway = coming(state);
  const auto comes = [&](const Steps& steps) {
    return std::includes(anyway.begin(), anyway.end(), steps.begin(), steps.end());
  };
  const auto& outcomes = courses_.after(state, action);
  return comes(taken(state, action)) && std::any_of(outcomes.begin(), outcomes.end(), [&](std::size_t next) {
           return courses_.is_held_back(next) || comes(coming(next));
         });
}

/// By relaxation: from the goals back, until nothing is nearer any more.
template <class Goals, class Outcomes>
Plans::Distances Plans::distances(const Goals& goals, const Outcomes& outcomes) {
  const std::size_t states = courses_.states().size();
  std::vector<std::set<std::size_t>> next(states);
  for (std::size_t s = 0; s < states; ++s)
    for (std::size_t a = 0; a < courses_.actions().size(); ++a) next[s].merge(outcomes(s, a));
  Distances result(states);
  for (std::size_t s = 0; s < states; ++s)
    if (goals(s)) result[s] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t s = 0; s < states; ++s)
      for (const std::size_t n : next[s])
        if (result[n] && (!result[s] || *result[s] > *result[n] + 1)) {
          result[s] = *result[n] + 1;
          changed = true;
        }
  }
  return result;
}

bool Plans::is_choice(std::size_t state, std::size_t action) {
  return permits(state, action) && (action == courses_.rest(state) || courses_.is_one_command(state, action));
}

std::optional<std::size_t> Plans::hoped(std::size_t state) {
  if (!hoped_)
    hoped_ = distances(
        [&](std::size_t s) { return is_met(s); },
        [&](std::size_t s, std::size_t a) { return is_choice(s, a) ? courses_.after(s, a) : std::set<std::size_t>{}; });
  return (*hoped_)[state];
}

std::optional<std::size_t> Plans::boldly(std::size_t state) {
  if (!boldly_)
    boldly_ = distances([&](std::size_t s) { return is_met(s); },
                        [&](std::size_t s, std::size_t a) {
                          const Steps& anyway = coming(s);
                          const Steps steps = taken(s, a);
                          const bool may = courses_.tolerates(s, a) &&
                                           std::includes(anyway.begin(), anyway.end(), steps.begin(), steps.end());
                          return may ? courses_.after(s, a) : std::set<std::size_t>{};
                        });
  return (*boldly_)[state];
}

std::optional<std::size_t> Plans::soberly(std::size_t state) {
  if (!soberly_)
    soberly_ = distances([&](std::size_t s) { return is_met(s); },
                         [&](std::size_t s, std::size_t a) { return sober_outcomes(s, a); });
  return (*soberly_)[state];
}

std::optional<std::size_t> Plans::surely(std::size_t state) {
  if (!surely_)
    surely_ = distances([&](std::size_t s) { return is_met(s) && courses_.stays(s); },
                        [&](std::size_t s, std::size_t a) { return sober_outcomes(s, a); });
  return (*surely_)[state];
}

/// Each way a step may go in which one thing happens at a time; none, where the action is doubtful.
std::set<std::size_t> Plans::sober_outcomes(std::size_t state, std::size_t action) {
  const bool single = is_single(courses_.step().plant(), courses_.actions()[action]);
  const bool idles = courses_.tolerates(state, courses_.idle()) && !courses_.after(state, courses_.idle()).empty();
  if (!single || !idles || !courses_.tolerates(state, action) || leaves_to_chance(state, action)) return {};
  return courses_.one_by_one(state, action);
}

/// Whether the action, and not idling, enables a forbidden step here or where time alone leads from there.
bool Plans::leaves_to_chance(std::size_t state, std::size_t action) {
  const auto enabled = [&](const Transition* t, std::size_t s, std::size_t a) {
    return courses_.enabled(s, a).contains(t);
  };
  const auto comes = [&](const Transition* t, std::size_t from) {
    const auto& later = courses_.by_itself(from);
    return std::any_of(later.begin(), later.end(), [&](std::size_t s) { return enabled(t, s, courses_.rest(s)); });
  };
  return std::any_of(forbidden_.begin(), forbidden_.end(), [&](const auto& forbidden) {
    const Transition* const t = forbidden.second;
    if (comes(t, state)) return false;
    const auto& outcomes = courses_.after(state, action);
    return enabled(t, state, action) ||
           std::any_of(outcomes.begin(), outcomes.end(), [&](std::size_t next) { return comes(t, next); });
  });
}

bool lasts(const automata::Plant& plant, const automata::Formula& goal) {
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const auto named = named_modes(plant, c, goal);
    for (const Transition& t : plant.components[c].transitions)
      if (t.timing && named.contains(t.from)) return false;
  }
  return true;
}

}  // namespace rmpl::reference
