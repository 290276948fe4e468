// A whole plan, by following the answers of a reconfigurer.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/plan.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/check.hpp"
#include "runtime/reasoning/reconfigure/circle.hpp"

namespace rmpl::runtime {

using automata::Modes;

namespace {

Plan no_plan(Reconfiguration answer) {
  return {.outcome = Plan::Outcome::no_plan,
          .goal_state = std::move(answer.goal_state),
          .commands = {},
          .states = {},
          .component = answer.component,
          .reason = std::move(answer.reason),
          .why = answer.why};
}

/// The plan as far as its step `end`.
Plan cut(Plan plan, std::size_t end) {
  plan.outcome = end == 0 ? Plan::Outcome::nothing_to_do : Plan::Outcome::plan;
  plan.commands.resize(end);
  plan.states.resize(end + 1);
  plan.goal_state = plan.states.back();
  return plan;
}

}  // namespace

Plan make_plan(const automata::Plant& plant, Reconfigurer& reconfigurer, const Modes& modes,
               const automata::Formula& goal) {
  Plan plan;
  Modes current = modes;
  StrategyPosition position;
  std::set<std::pair<Modes, StrategyPosition>> seen;
  std::optional<std::size_t> achieved;  // after so many commands the goal is entailed
  while (seen.emplace(current, position).second) {
    Reconfiguration answer = reconfigurer.go_on(current, goal, position);
    plan.sure = plan.sure && answer.sure;
    plan.bounds_counted = plan.bounds_counted && answer.bounds_counted;
    plan.proved_best = plan.proved_best && answer.why.proved_best;
    if (answer.why.purpose != Reason::Purpose::goal) achieved = plan.commands.size();
    switch (answer.outcome) {
      case Reconfiguration::Outcome::nothing_to_do:
        plan.outcome = plan.commands.empty() ? Plan::Outcome::nothing_to_do : Plan::Outcome::plan;
        plan.states.push_back(current);
        plan.goal_state = std::move(current);
        return plan;
      case Reconfiguration::Outcome::no_plan:
        // What is lost again by itself was achieved all the same.
        if (achieved && !plan.states.empty()) return cut(std::move(plan), *achieved);
        return no_plan(std::move(answer));
      case Reconfiguration::Outcome::command:
      case Reconfiguration::Outcome::wait:
        CHECK(answer.expected && "a command and a wait lead somewhere");
        if (!plan.goal_state) plan.goal_state = std::move(answer.goal_state);
        // The goal is achieved, and the model asks for an action all the same.
        if (*answer.expected == current) {
          plan.outcome = Plan::Outcome::plan;
          plan.states.push_back(current);
          plan.goal_state = current;
          if (!plan.commands.empty()) return plan;
          plan.commands.push_back(std::move(answer.action));
          plan.states.push_back(current);
          return plan;
        }
        plan.states.push_back(current);
        plan.commands.push_back(std::move(answer.action));
        position = position_after(answer, *answer.expected);
        current = std::move(*answer.expected);
        break;
    }
  }
  if (achieved) return cut(std::move(plan), *achieved);
  plan.states.push_back(current);
  const auto first = std::ranges::find(plan.states, current);
  const Circle circle = circle_in(plant, {first, plan.states.end()});
  return {.outcome = Plan::Outcome::no_plan,
          .goal_state = std::move(plan.goal_state),
          .commands = {},
          .states = {},
          .component = circle.back.component,
          .reason = "livelock: the commands for the goal repeat for ever: " + to_text(circle, plant),
          .why = {.purpose = Reason::Purpose::goal, .obstacle = Reason::Obstacle::not_found, .step = circle.back}};
}

Plan make_one_step_plan(Reconfigurer& reconfigurer, const Modes& modes, const automata::Formula& goal) {
  Reconfiguration answer = reconfigurer.next(modes, goal);
  Plan plan;
  plan.sure = plan.bounds_counted = false;
  switch (answer.outcome) {
    case Reconfiguration::Outcome::nothing_to_do:
      plan.goal_state = modes;
      break;
    case Reconfiguration::Outcome::no_plan:
      return no_plan(std::move(answer));
    case Reconfiguration::Outcome::command:
    case Reconfiguration::Outcome::wait:
      plan.outcome = Plan::Outcome::plan;
      plan.states = {modes, *answer.expected};
      plan.goal_state = std::move(answer.expected);
      plan.commands.push_back(std::move(answer.action));
      break;
  }
  return plan;
}

}  // namespace rmpl::runtime
