// The goal interpreter and the planner against enumeration and nominal execution.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "runtime/reasoning/reconfigure/one_step.hpp"
#include "runtime/reasoning/reconfigure/plan.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "tests/property/draw.hpp"
#include "tests/property/generate.hpp"
#include "tests/reference/goals.hpp"

namespace rmpl::property {
namespace {

using automata::Formula;
using automata::Modes;

/// Mostly modes that are to be reached, as programs ask for; sometimes a value of an attribute.
Formula draw_goal(const automata::Plant& plant) {
  std::vector<Formula> parts;
  for (automata::Assignment a : reference::assumptions_of(plant, *modes_of(plant)))
    if (chance(50)) parts.push_back(automata::is(a.variable, a.value));
  if (parts.empty() || chance(20)) parts.push_back(*formulas(plant.variables, all_variables(plant), 0));
  return automata::conjunction(std::move(parts));
}

const Shape planning = {.max_modes = 4, .distributions = false, .rewards = true};

RC_GTEST_PROP(Reconfigure, GoalStateIsTheBestOfAll, ()) {
  const Model model = *models(planning);
  const reference::Step slow(model.plant);
  automata::PlantStep step(model.plant);
  const auto reconfigurer = runtime::make_reconfigurer(step);
  for (int question = 0; question < 4; ++question) {
    const Modes modes = *modes_of(model.plant);
    const Formula goal = draw_goal(model.plant);
    if (!slow.possible(modes) || goal.is_true()) continue;
    const auto expected = reference::best_goal_state(slow, modes, goal);
    const runtime::Reconfiguration found = reconfigurer->next(modes, goal);
    RC_LOG() << automata::to_text(goal, model.plant.variables) << ": " << found.reason << std::endl;
    if (!expected) {
      RC_ASSERT(found.outcome == runtime::Reconfiguration::Outcome::no_plan);
    } else {
      RC_ASSERT(found.goal_state == std::optional(expected->modes));
      RC_ASSERT((found.outcome == runtime::Reconfiguration::Outcome::nothing_to_do) == (expected->modes == modes));
    }
  }
}

RC_GTEST_PROP(Reconfigure, PlansLeadToTheGoalState, ()) {
  const Model model = *models(planning);
  const reference::Step slow(model.plant);
  automata::PlantStep step(model.plant);
  const auto reconfigurer = runtime::make_reconfigurer(step);
  for (int question = 0; question < 4; ++question) {
    const Modes modes = *modes_of(model.plant);
    const Formula goal = draw_goal(model.plant);
    if (!slow.possible(modes)) continue;
    const runtime::Plan plan = runtime::make_plan(*reconfigurer, modes, goal);
    RC_LOG() << automata::to_text(goal, model.plant.variables) << ": " << plan.reason << std::endl;
    if (plan.outcome == runtime::Plan::Outcome::no_plan) continue;
    RC_ASSERT((plan.outcome == runtime::Plan::Outcome::nothing_to_do) == plan.commands.empty());
    RC_ASSERT(reference::nominal_outcomes(slow, modes, plan.commands).contains(*plan.goal_state));
    RC_ASSERT(slow.models().entails(reference::assumptions_of(model.plant, *plan.goal_state), goal));
  }
}

/// Where nothing happens without a command, and what it does is certain and can be undone, what can be reached is.
RC_GTEST_PROP(Reconfigure, PlansAreFoundWhereTheyExist, ()) {
  const Model model = *models({.max_attributes = 6,
                               .faults = false,
                               .timed = false,
                               .distributions = false,
                               .rewards = true,
                               .commanded = true});
  const reference::Step slow(model.plant);
  automata::PlantStep step(model.plant);
  const auto reconfigurer = runtime::make_reconfigurer(step);
  for (int question = 0; question < 4; ++question) {
    const Modes modes = *modes_of(model.plant);
    const Formula goal = draw_goal(model.plant);
    if (!slow.possible(modes) || goal.is_true()) continue;
    const auto target = reference::best_goal_state(slow, modes, goal);
    if (!target) continue;
    const auto commands = reference::shortest_reversible_plan(slow, modes, target->modes);
    if (!commands) continue;
    const runtime::Plan plan = runtime::make_plan(*reconfigurer, modes, goal);
    RC_LOG() << automata::to_text(goal, model.plant.variables) << ": " << plan.reason << ", where " << commands->size()
             << " commands do it" << std::endl;
    RC_ASSERT(plan.outcome != runtime::Plan::Outcome::no_plan);
  }
}

RC_GTEST_PROP(Reconfigure, OneStepIsTheCheapestActionOfAll, ()) {
  const Model model = *models(planning);
  const reference::Step slow(model.plant);
  automata::PlantStep step(model.plant);
  const auto reconfigurer = runtime::make_one_step_reconfigurer(step);
  for (int question = 0; question < 6; ++question) {
    std::vector<Modes> tracked;
    for (int i = 0; i < 3; ++i) {
      const Modes modes = *modes_of(model.plant);
      if (slow.possible(modes) && (tracked.empty() || chance(50))) tracked.push_back(modes);
    }
    const Formula goal = draw_goal(model.plant);
    if (tracked.empty() || goal.is_true()) continue;
    const auto expected = reference::cheapest_action(slow, tracked, goal);
    const runtime::Reconfiguration found = reconfigurer->next_of_all(tracked, goal);
    RC_LOG() << automata::to_text(goal, model.plant.variables) << ": " << found.reason << std::endl;
    RC_ASSERT((found.outcome == runtime::Reconfiguration::Outcome::no_plan) == !expected);
    if (expected) RC_ASSERT(found.action == *expected);
  }
}

}  // namespace
}  // namespace rmpl::property
