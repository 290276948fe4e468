// Plans by looking at every state.
// SPDX-License-Identifier: MIT
#include "tests/reference/plans.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/reference/goals.hpp"

namespace rmpl::reference {

using automata::ControlAction;
using automata::Modes;
using automata::Transition;

namespace {

/// What one goal allows of one plant.
class Search {
 public:
  Search(const Step& step, const automata::Formula& goal)
      : step_(step), goal_(goal), idle_(automata::idle_action(step.plant())) {
    for (std::size_t i = 0; i < step.plant().components.size(); ++i)
      for (const Transition& t : step.plant().components[i].transitions)
        if (is_forbidden(step, i, t, goal)) forbidden_.emplace_back(i, &t);
    for (const ControlAction& action : all_actions(step.plant()))
      if (is_single(step.plant(), action)) actions_.push_back(action);
  }

  std::optional<std::size_t> from(const Modes& modes) {
    std::map<Modes, std::size_t> cycles{{modes, 0}};
    std::vector<Modes> open{modes};
    for (std::size_t next = 0; next < open.size(); ++next) {
      const Modes state = open[next];
      if (step_.models().entails(assumptions_of(step_.plant(), state), goal_) && stays(state)) return cycles.at(state);
      for (const ControlAction& action : actions_) {
        if (!tolerates(state, action) || takes_forbidden(state, action)) continue;
        for (const Modes& after : single_outcomes(state, action))
          if (cycles.try_emplace(after, cycles.at(state) + 1).second) open.push_back(after);
      }
    }
    return std::nullopt;
  }

 private:
  bool tolerates(const Modes& modes, const ControlAction& action) const {
    return step_.models().consistent(assumptions_of(step_.plant(), modes, action));
  }

  bool stays(const Modes& modes) const {
    return tolerates(modes, idle_) && nominal_successors(step_, modes, idle_) == std::set<Modes>{modes};
  }

  /// Each way a step may go in which one thing happens at a time.
  std::set<Modes> single_outcomes(const Modes& modes, const ControlAction& action) const {
    std::set<Modes> result;
    for (const Modes& next : nominal_successors(step_, modes, action)) {
      std::size_t timed = 0;
      std::size_t untimed = 0;
      for (std::size_t i = 0; i < modes.size(); ++i) {
        if (next[i] == modes[i]) continue;
        const auto& transitions = step_.plant().components[i].transitions;
        const bool now = std::any_of(transitions.begin(), transitions.end(), [&](const Transition& t) {
          return t.from == modes[i] && t.to == next[i] && !t.timing && can_be_taken(t) &&
                 step_.enabled(t, modes, action);
        });
        ++(now ? untimed : timed);
      }
      if (timed <= (untimed > 0 ? 0u : 1u)) result.insert(next);
    }
    return result;
  }

  /// Whether the action, and no idle one, enables a forbidden step here or where time alone leads from there.
  bool takes_forbidden(const Modes& modes, const ControlAction& action) const {
    if (action == idle_) return false;
    if (enables_forbidden(modes, action, tolerates(modes, idle_))) return true;
    for (const Modes& after : nominal_successors(step_, modes, action)) {
      std::vector<Modes> open{after};
      std::set<Modes> seen{after};
      for (std::size_t next = 0; next < open.size(); ++next) {
        const Modes state = open[next];
        if (!tolerates(state, idle_)) continue;
        if (enables_forbidden(state, idle_, false)) return true;
        for (const Modes& further : nominal_successors(step_, state, idle_))
          if (seen.insert(further).second) open.push_back(further);
      }
    }
    return false;
  }

  bool enables_forbidden(const Modes& modes, const ControlAction& action, bool can_idle) const {
    return std::any_of(forbidden_.begin(), forbidden_.end(), [&](const auto& forbidden) {
      const auto& [component, t] = forbidden;
      return t->from == modes[component] && step_.enabled(*t, modes, action) &&
             !(can_idle && step_.enabled(*t, modes, idle_));
    });
  }

  const Step& step_;
  const automata::Formula& goal_;
  ControlAction idle_;
  std::vector<std::pair<std::size_t, const Transition*>> forbidden_;  ///< by component
  std::vector<ControlAction> actions_;
};

}  // namespace

std::optional<std::size_t> fewest_cycles(const Step& step, const Modes& modes, const automata::Formula& goal) {
  return Search(step, goal).from(modes);
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
