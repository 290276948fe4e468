// Goals of single components, in causal order.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/subgoals.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "base/check.hpp"
#include "runtime/reasoning/nominal/idling.hpp"
#include "runtime/reasoning/reconfigure/impasse.hpp"
#include "runtime/reasoning/reconfigure/policy.hpp"
#include "runtime/reasoning/reconfigure/reachable_modes.hpp"
#include "runtime/reasoning/reconfigure/strategy_answer.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Formula;
using automata::ModeId;
using automata::Modes;
using automata::ValueId;

namespace {

/// Steps of one component that are tried before it has no plan.
constexpr std::size_t most_tries = 256;

bool is_met(const std::vector<ValueId>& modes, ModeId mode) {
  return std::binary_search(modes.begin(), modes.end(), ValueId(mode.index()));
}

}  // namespace

Subgoals::Subgoals(automata::PlantStep& step, const NominalGraph& graph, std::shared_ptr<PlantGames> common)
    : step_(step),
      graph_(graph),
      common_(std::move(common)),
      order_(step.plant(), graph),
      interpreter_(step, graph),
      steps_(step) {}

Reconfiguration Subgoals::next(const Modes& modes, const Goal& goal) {
  if (interpreter_.entailed(modes, goal)) {
    Reconfiguration achieved = at_rest(step_, modes);
    achieved.goal_state = modes;
    return achieved;
  }
  auto interpreted = interpreter_.interpret(modes, goal, ReachableModes(graph_, modes, goal));
  if (auto* impasse = std::get_if<Impasse>(&interpreted)) return no_plan(step_, modes, std::move(*impasse));
  auto& target = std::get<Modes>(interpreted);
  std::optional<Reconfiguration> wait;
  std::vector<TransitionOf> awaited;
  for (const ComponentId c : order_.downstream_first()) {
    if (modes[c.index()] == target[c.index()]) continue;
    auto answer = achieve(modes, goal, {c, {ValueId(target[c.index()].index())}});
    if (!answer && wait) continue;
    if (!answer) return not_found(modes, goal, c, target[c.index()]);
    answer->why.conjunct = open_part(modes, goal, c);
    answer->why.component = c;
    answer->why.aim = target[c.index()];
    answer->why.proved_best = false;
    answer->goal_state = target;
    if (answer->outcome == Reconfiguration::Outcome::command) {
      if (still_come(awaited, *answer->expected)) return *std::move(answer);
      continue;
    }
    if (!answer->why.step) return wait ? *std::move(wait) : *std::move(answer);
    awaited.push_back(*answer->why.step);
    if (!wait) wait = std::move(answer);
  }
  CHECK(wait && "a state that does not entail the goal is none that does");
  return *std::move(wait);
}

/// Whether what is waited for may still come by itself in these modes.
bool Subgoals::still_come(const std::vector<TransitionOf>& awaited, const Modes& modes) {
  const automata::ControlAction rest = resting_action(step_, modes);
  return std::all_of(awaited.begin(), awaited.end(), [&](const TransitionOf& of) {
    const NominalTransition* const t = graph_.find(of.component, of.transition);
    return t != nullptr && modes[of.component.index()] == t->from && graph_.met(*t, modes, rest);
  });
}

Reconfiguration Subgoals::not_found(const Modes& modes, const Goal& goal, ComponentId component, ModeId mode) {
  const automata::Component& automaton = step_.plant()[component];
  Impasse impasse{component, "no sequence of commands was found that brings '" + automaton.name + "' to '" +
                                 automaton.modes[mode.index()].name + "'; the goal is too large for an exact search"};
  impasse.why.purpose = Reason::Purpose::goal;
  impasse.why.obstacle = Reason::Obstacle::not_found;
  impasse.why.conjunct = open_part(modes, goal, component);
  return no_plan(step_, modes, std::move(impasse));
}

/// The part of the goal that is open, of those that speak of the component where there is one.
std::optional<std::uint32_t> Subgoals::open_part(const Modes& modes, const Goal& goal, ComponentId served) {
  const auto now = assignments_of(step_.plant(), modes);
  const std::vector<Formula> parts = conjuncts_of(goal.formula());
  std::optional<std::uint32_t> first;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const auto variables = variables_of(parts[i]);
    const bool about = std::binary_search(variables.begin(), variables.end(), step_.plant()[served].mode);
    if ((first && !about) || step_.theory().entails(now, step_.theory().encode(parts[i]))) continue;
    if (about) return i;
    first = i;
  }
  return first;
}

/// Goes upstream from component to component as long as a step lacks something; takes the first step that lacks
/// nothing. A component that is under way already is no way to itself.
std::optional<Reconfiguration> Subgoals::achieve(const Modes& modes, const Goal& goal, const Wanted& wanted) {
  Barred barred;
  for (std::size_t tries = 0; tries < most_tries; ++tries) {
    std::vector<bool> under_way(modes.size());
    std::optional<std::tuple<ComponentId, automata::TransitionId, std::size_t>> taken_for;
    Wanted now = wanted;
    for (;;) {
      under_way[now.component.index()] = true;
      auto step = first_step(modes, goal, now, barred, under_way);
      if (!step) {
        if (!taken_for) return std::nullopt;
        barred.insert(*taken_for);
        break;
      }
      const auto key = std::tuple(now.component, step->transition->id, step->precondition);
      if (!step->before) {
        if (auto answer = take(modes, now, *step->transition)) return answer;
        // What else it could be taken by changes nothing in these modes.
        for (std::size_t p = 0; p < step->transition->preconditions.size(); ++p)
          barred.insert({now.component, step->transition->id, p});
        break;
      }
      taken_for = key;
      now = *std::move(step->before);
    }
  }
  return std::nullopt;
}

/// The first step of a shortest way to a wanted mode, by the precondition that lacks the fewest modes of others; of
/// several the first. None where all are barred.
std::optional<Subgoals::Step> Subgoals::first_step(const Modes& modes, const Goal& goal, const Wanted& wanted,
                                                   const Barred& barred, const std::vector<bool>& under_way) const {
  const ComponentId c = wanted.component;
  const ModeId from = modes[c.index()];
  const auto& transitions = graph_.transitions(c);
  const auto is_open = [&](const NominalTransition& t, std::size_t p) {
    if (!order_.goes_upstream(c, t.preconditions[p])) return false;
    if (t.from != from) return true;
    if (barred.contains({c, t.id, p})) return false;
    const auto before = lacking(modes, t.preconditions[p], c).first;
    return !before || !under_way[before->component.index()];
  };
  std::vector<bool> permitted;
  for (const NominalTransition& t : transitions) {
    const bool licensed = !t.irreversible || t.licensed || graph_.leads_to_named(c, t.to, goal.named());
    bool open = false;
    for (std::size_t p = 0; p < t.preconditions.size() && licensed && !open; ++p) open = is_open(t, p);
    permitted.push_back(open);
  }
  const Policy policy(transitions, graph_.mode_count(c), permitted);
  std::optional<Distance> least;
  const NominalTransition* next = nullptr;
  for (const ValueId mode : wanted.modes) {
    const auto& distance = policy.distance(from, ModeId(mode.index()));
    if (!distance || (least && *least <= *distance)) continue;
    least = distance;
    next = policy.next(from, ModeId(mode.index()));
  }
  if (next == nullptr) return std::nullopt;
  std::optional<Step> step;
  std::size_t fewest = 0;
  for (std::size_t p = 0; p < next->preconditions.size(); ++p) {
    if (!is_open(*next, p)) continue;
    Lack lack = lacking(modes, next->preconditions[p], c);
    if (step && fewest <= lack.count) continue;
    step = Step{next, p, std::move(lack.first)};
    fewest = lack.count;
  }
  return step;
}

Subgoals::Lack Subgoals::lacking(const Modes& modes, const Precondition& precondition, ComponentId component) const {
  Lack lack;
  for (const Requirement& r : precondition) {
    const auto other = graph_.component_of(r);
    if (!other || *other == component || is_met(r.values, modes[other->index()])) continue;
    ++lack.count;
    if (!lack.first || order_.rank(*other) < order_.rank(lack.first->component)) lack.first = Wanted{*other, r.values};
  }
  return lack;
}

/// By the strategy that comes to where the transition leads, the components that it neither moves nor disturbs held.
std::optional<Reconfiguration> Subgoals::take(const Modes& modes, const Wanted& wanted, const NominalTransition& t) {
  const auto mode = step_.plant()[wanted.component].mode;
  const Formula there = automata::is(mode, ValueId(t.to.index()));
  auto& strategist = steps_.find(there).memory;
  if (!strategist) {
    strategist = std::make_unique<Strategist>(step_, graph_, there, std::nullopt, Strategist::Relevant::read,
                                              Strategist::Least::large, common_);
  }
  auto answer = strategy_answer(step_, graph_, *strategist, modes, {});
  const bool leads_on = answer && answer->expected && *answer->expected != modes;
  if (!leads_on || answer->outcome == Reconfiguration::Outcome::no_plan) return std::nullopt;
  answer->sure = answer->bounds_counted = false;
  answer->edges = nullptr;
  return answer;
}

}  // namespace rmpl::runtime
