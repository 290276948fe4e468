// Reconfiguration against enumeration and nominal execution.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <random>
#include <set>

#include "runtime/reasoning/nominal/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/one_step.hpp"
#include "runtime/reasoning/reconfigure/plan.hpp"
#include "runtime/reasoning/reconfigure/policy.hpp"
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

const Shape certain = {.max_modes = 4,
                       .max_attributes = 6,
                       .faults = false,
                       .timed = false,
                       .distributions = false,
                       .rewards = true,
                       .commanded = true};

/// A random plant, its twin, and who is asked.
struct Subject {
  explicit Subject(const Shape& shape) : model(*models(shape)) {}

  const Model model;
  const reference::Step slow{model.plant};
  automata::PlantStep step{model.plant};
  const std::unique_ptr<runtime::Reconfigurer> reconfigurer = runtime::make_reconfigurer(step);
};

bool entails(const reference::Step& slow, const Modes& modes, const Formula& goal) {
  return slow.models().entails(reference::assumptions_of(slow.plant(), modes), goal);
}

/// Preconditions fit a consistent state and control action where these imply the guard, and only there.
RC_GTEST_PROP(Reconfigure, PreconditionsAreWhatImpliesTheGuard, ()) {
  const Model model = *models(planning);
  const reference::Step slow(model.plant);
  const runtime::NominalGraph graph(model.plant);
  for (int question = 0; question < 8; ++question) {
    const Modes modes = *modes_of(model.plant);
    const auto action = *actions_of(model.plant);
    const auto store = reference::assumptions_of(model.plant, modes, action);
    if (!slow.models().consistent(store)) continue;
    const auto fits = [&](const runtime::Requirement& r) {
      return std::any_of(store.begin(), store.end(), [&](automata::Assignment a) {
        return a.variable == r.variable && std::binary_search(r.values.begin(), r.values.end(), a.value);
      });
    };
    for (std::size_t c = 0; c < modes.size(); ++c) {
      const automata::Component& component = model.plant.components[c];
      for (std::size_t t = 0; t < component.transitions.size(); ++t) {
        const automata::Transition& transition = component.transitions[t];
        if (transition.from != modes[c] || component.is_fault(transition)) continue;
        const bool weightless =
            transition.weight.kind != automata::Weight::Kind::none && !(transition.weight.value > 0);
        const auto* const found = graph.find(automata::ComponentId(c), automata::TransitionId(t));
        const bool fit =
            found != nullptr && std::any_of(found->preconditions.begin(), found->preconditions.end(),
                                            [&](const runtime::Precondition& precondition) {
                                              return std::all_of(precondition.begin(), precondition.end(), fits);
                                            });
        RC_ASSERT(fit == (!weightless && slow.models().entails(store, transition.guard)));
      }
    }
  }
}

RC_GTEST_PROP(Reconfigure, WhatIsAchievedIsNeverNoPlanAndStaysAchieved, ()) {
  const Subject subject(planning);
  for (int question = 0; question < 4; ++question) {
    const Modes modes = *modes_of(subject.model.plant);
    const Formula goal = draw_goal(subject.model.plant);
    if (!subject.slow.possible(modes) || goal.is_true() || !entails(subject.slow, modes, goal)) continue;
    const runtime::Reconfiguration found = subject.reconfigurer->next(modes, goal);
    RC_ASSERT(found.outcome != runtime::Reconfiguration::Outcome::no_plan);
    if (!found.expected || found.why.purpose != runtime::Reason::Purpose::reward) continue;
    RC_ASSERT(entails(subject.slow, *found.goal_state, goal));
    // What goes on by itself is no choice.
    const auto idle = automata::idle_action(subject.model.plant);
    if (reference::nominal_successors(subject.slow, modes, idle) != std::set{modes}) continue;
    RC_ASSERT(reference::reward_of(subject.model.plant, *found.goal_state) >=
              reference::reward_of(subject.model.plant, modes));
    for (std::size_t c = 0; c < modes.size(); ++c) {
      if ((*found.goal_state)[c] != modes[c]) RC_ASSERT(reference::is_swayed(subject.slow, c, modes[c]));
    }
  }
}

RC_GTEST_PROP(Reconfigure, NothingForbiddenIsCommanded, ()) {
  const Subject subject(planning);
  for (int question = 0; question < 4; ++question) {
    const Modes modes = *modes_of(subject.model.plant);
    const Formula goal = draw_goal(subject.model.plant);
    if (!subject.slow.possible(modes)) continue;
    const runtime::Reconfiguration found = subject.reconfigurer->next(modes, goal);
    if (found.outcome != runtime::Reconfiguration::Outcome::command) continue;
    if (found.why.purpose == runtime::Reason::Purpose::model) continue;
    RC_LOG() << automata::to_text(goal, subject.model.plant.variables) << std::endl;
    RC_ASSERT(!reference::forbidden_step(subject.slow, modes, found.action, goal));
  }
}

RC_GTEST_PROP(Reconfigure, PlansLeadToTheGoal, ()) {
  const Subject subject(planning);
  for (int question = 0; question < 4; ++question) {
    const Modes modes = *modes_of(subject.model.plant);
    const Formula goal = draw_goal(subject.model.plant);
    if (!subject.slow.possible(modes) || entails(subject.slow, modes, goal)) continue;
    const runtime::Plan plan = runtime::make_plan(subject.model.plant, *subject.reconfigurer, modes, goal);
    RC_LOG() << automata::to_text(goal, subject.model.plant.variables) << ": " << plan.reason << std::endl;
    if (plan.outcome == runtime::Plan::Outcome::no_plan) continue;
    RC_ASSERT((plan.outcome == runtime::Plan::Outcome::nothing_to_do) == plan.commands.empty());
    const auto ends = reference::nominal_outcomes(subject.slow, modes, plan.commands);
    RC_ASSERT(
        std::any_of(ends.begin(), ends.end(), [&](const Modes& end) { return entails(subject.slow, end, goal); }));
  }
}

/// Whether the goal needs the same of every goal state, as far as no modes exclude each other.
bool asks_for_modes(const automata::Plant& plant, const Formula& goal) {
  const auto conjuncts = conjuncts_of(goal);
  return std::all_of(conjuncts.begin(), conjuncts.end(), [&](const Formula& conjunct) {
    return conjunct.kind == Formula::Kind::member && conjunct.values.size() == 1 &&
           plant.component_of(conjunct.variable);
  });
}

bool is_rewarded(const automata::Plant& plant) {
  return std::any_of(plant.components.begin(), plant.components.end(), [](const automata::Component& component) {
    return std::any_of(component.modes.begin(), component.modes.end(),
                       [](const auto& mode) { return mode.reward != 0; });
  });
}

/// Where nothing happens without a command, and what it does is certain and can be undone, what can be reached is:
/// modes in no more cycles than it takes, and that of one component without moving others, if it can be in as many;
/// beside a goal that is entailed what is worth most, then what moves fewest.
RC_GTEST_PROP(Reconfigure, PlansAreFoundWhereTheyExist, ()) {
  Shape shape = certain;
  shape.rewards = chance(50);
  const Subject subject(shape);
  for (int question = 0; question < 4; ++question) {
    const Modes modes = *modes_of(subject.model.plant);
    const Formula goal = draw_goal(subject.model.plant);
    if (!subject.slow.possible(modes) || goal.is_true()) continue;
    const auto commands = reference::fewest_commands(subject.slow, modes, goal);
    if (!commands) continue;
    const runtime::Plan plan = runtime::make_plan(subject.model.plant, *subject.reconfigurer, modes, goal);
    RC_LOG() << automata::to_text(goal, subject.model.plant.variables) << ": " << plan.reason << ", where " << *commands
             << " commands do it" << std::endl;
    RC_ASSERT(plan.outcome != runtime::Plan::Outcome::no_plan);
    if (asks_for_modes(subject.model.plant, goal)) {
      std::size_t cycles = 0;
      Modes at = modes;
      for (; !entails(subject.slow, at, goal); ++cycles) at = *subject.reconfigurer->next(at, goal).expected;
      RC_ASSERT(cycles <= *commands);
      const auto asked = subject.model.plant.component_of(conjuncts_of(goal).front().variable);
      if (conjuncts_of(goal).size() == 1 && !is_rewarded(subject.model.plant)) {
        const auto alone = reference::fewest_commands_alone(subject.slow, modes, *asked, goal);
        at[asked->index()] = modes[asked->index()];
        RC_ASSERT(!alone || *alone > *commands || at == modes);
      }
    }
    // What is worth more may be out of reach where the goal is to be kept.
    if (*commands > 0) continue;
    const auto aim = subject.reconfigurer->next(modes, goal).goal_state;
    const Modes best = reference::best_kept(subject.slow, modes, goal);
    RC_ASSERT(!reference::is_better(subject.model.plant, modes, best, *aim));
  }
}

/// A goal may be kept by restarts, which are then commanded for ever.
Shape without_restarts(Shape shape) {
  shape.restarts = 0;
  return shape;
}

/// Whether nothing happens while all controls are idle, and nothing is due: what is due where it cannot come gets
/// stuck, so that a command may have to be held for ever.
bool is_quiet(const reference::Step& step, const Modes& modes) {
  const auto idle = automata::idle_action(step.plant());
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const automata::Component& component = step.plant().components[c];
    for (const automata::Transition& t : component.transitions) {
      if (t.from == modes[c] && t.timing && !component.is_fault(t) && step.enabled(t, modes, idle)) return false;
    }
  }
  return reference::nominal_successors(step, modes, idle) == std::set{modes};
}

/// Closed runs in which all goes as expected: while nothing happens of itself no state comes again, so commands come to
/// an end.
RC_GTEST_PROP(Reconfigure, CommandsComeToAnEnd, ()) {
  const Subject subject(without_restarts(planning));
  for (int question = 0; question < 4; ++question) {
    Modes modes = *modes_of(subject.model.plant);
    const Formula goal = draw_goal(subject.model.plant);
    if (!subject.slow.possible(modes) || goal.is_true()) continue;
    RC_LOG() << automata::to_text(goal, subject.model.plant.variables) << std::endl;
    std::set<Modes> seen;
    for (int cycle = 0; cycle < 100; ++cycle) {
      const runtime::Reconfiguration answer = subject.reconfigurer->next(modes, goal);
      if (!answer.expected || answer.why.purpose == runtime::Reason::Purpose::model) break;
      RC_ASSERT(seen.insert(modes).second);
      RC_ASSERT(reference::nominal_successors(subject.slow, modes, answer.action).contains(*answer.expected));
      if (!is_quiet(subject.slow, modes)) seen.clear();
      modes = *answer.expected;
    }
  }
}

/// The same where what is hoped for does not always happen: each cycle goes one of the ways that it can go nominally.
/// A command that may fail is sent again, so this takes as long as chance has it; but where nothing happens of itself
/// it is not for ever.
RC_GTEST_PROP(Reconfigure, CommandsComeToAnEndWhateverTheyLeadTo, ()) {
  const Subject subject(without_restarts(planning));
  std::mt19937 random(static_cast<unsigned>(up_to(0, 1u << 30)));
  for (int question = 0; question < 4; ++question) {
    Modes modes = *modes_of(subject.model.plant);
    const Formula goal = draw_goal(subject.model.plant);
    if (!subject.slow.possible(modes) || goal.is_true()) continue;
    RC_LOG() << automata::to_text(goal, subject.model.plant.variables) << " from " << rc::toString(modes) << std::endl;
    int quiet = 0;
    for (int cycle = 0; cycle < 1000; ++cycle) {
      const runtime::Reconfiguration answer = subject.reconfigurer->next(modes, goal);
      if (!answer.expected || answer.why.purpose == runtime::Reason::Purpose::model) break;
      const auto successors = reference::nominal_successors(subject.slow, modes, answer.action);
      RC_ASSERT(successors.contains(*answer.expected));
      quiet = is_quiet(subject.slow, modes) ? quiet + 1 : 0;
      RC_ASSERT(quiet < 300);
      modes = *std::next(successors.begin(), static_cast<std::ptrdiff_t>(random() % successors.size()));
    }
  }
}

/// Whether what enables a transition may let its component go another way as well.
bool may_go_elsewhere(automata::PlantStep& step, const automata::Component& component,
                      const automata::Transition& way) {
  return std::any_of(component.transitions.begin(), component.transitions.end(), [&](const automata::Transition& t) {
    if (t.from != way.from || t.to == way.to) return false;
    return step.theory().allows({}, step.theory().encode(automata::conjunction({t.guard, way.guard})));
  });
}

/// Of how many steps a table's way is, where each leads to one mode only: a table says nothing of where else a command
/// leads, which may be where no plan may go.
std::optional<std::size_t> certain_way(automata::PlantStep& step, const automata::Component& component,
                                       const runtime::PolicyTable& table, automata::ModeId at,
                                       automata::ModeId target) {
  std::size_t steps = 0;
  for (; at != target; ++steps) {
    const auto& entry = table.entries[at.index()][target.index()];
    if (entry.kind == runtime::PolicyEntry::Kind::failure) return std::nullopt;
    const automata::Transition& way = component.transitions[entry.transition.index()];
    if (may_go_elsewhere(step, component, way)) return std::nullopt;
    at = way.to;
  }
  return steps;
}

/// What `plan` does to a component is on a shortest way of its policy table, where the component depends on no other.
RC_GTEST_PROP(Reconfigure, PlansFollowThePolicies, ()) {
  const Model model = *models(certain);
  automata::PlantStep step(model.plant);
  const auto reconfigurer = runtime::make_reconfigurer(step);
  for (std::size_t c = 0; c < model.plant.components.size(); ++c) {
    const automata::Component& component = model.plant.components[c];
    const auto table = runtime::policy_table(model.plant, automata::ComponentId(c));
    Modes modes = *modes_of(model.plant);
    const automata::ModeId target(up_to(0, component.modes.size() - 1));
    const Formula goal = automata::is(component.mode, automata::ValueId(target.index()));
    if (!step.possible(modes)) continue;
    for (int cycle = 0; cycle < 100 && modes[c] != target; ++cycle) {
      const runtime::Reconfiguration answer = reconfigurer->next(modes, goal);
      RC_LOG() << component.name << " " << modes[c].value << " to " << target.value << " " << answer.reason
               << std::endl;
      const bool none = answer.outcome == runtime::Reconfiguration::Outcome::no_plan;
      const auto kind = table.entries[modes[c].index()][target.index()].kind;
      if (kind == runtime::PolicyEntry::Kind::failure) RC_ASSERT(none);
      if (none) break;
      RC_ASSERT(answer.expected.has_value());
      const automata::ModeId next = (*answer.expected)[c];
      if (next != modes[c]) {
        const auto whole = certain_way(step, component, table, modes[c], target);
        if (!whole) break;
        const auto rest = certain_way(step, component, table, next, target);
        RC_ASSERT(!rest || *rest + 1 == *whole);
      }
      modes = *answer.expected;
    }
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
    const runtime::Reconfiguration found = reconfigurer->next_of_all(tracked, goal, {});
    RC_LOG() << automata::to_text(goal, model.plant.variables) << ": " << found.reason << std::endl;
    RC_ASSERT((found.outcome == runtime::Reconfiguration::Outcome::no_plan) == !expected);
    if (expected) RC_ASSERT(found.action == *expected);
  }
}

}  // namespace
}  // namespace rmpl::property
