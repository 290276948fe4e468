// The reactive planner: walks through the policies to the goal state, and what is remembered of them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "base/check.hpp"
#include "runtime/reasoning/reconfigure/circle.hpp"
#include "runtime/reasoning/reconfigure/planner.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Modes;

bool Planner::may_take(const Modes& modes, const Objective& objective, const automata::ControlAction& action,
                       const NominalOutcome& outcome) {
  if (!objective.keeps) return true;
  if (!objective.keeps(outcome.modes)) return false;
  const bool waits = std::any_of(outcome.moves.begin(), outcome.moves.end(), [&](const NominalMove& move) {
    return move.transition->timed && !objective.moved[move.component.index()];
  });
  if (waits) return false;
  const std::vector<Modes> besides = nominal_.let_come(modes, action, objective.part);
  return std::all_of(besides.begin(), besides.end(), objective.keeps);
}

std::vector<std::uint64_t> Planner::question(const Modes& modes, const Objective& objective) const {
  std::vector<std::uint64_t> key{objective.part, *objective.keeps_number};
  for (const ComponentId c : parts_.components(objective.part)) {
    key.push_back(std::uint64_t{modes[c.index()].value} << 32 | objective.target[c.index()].value);
  }
  for (const ComponentId c : parts_.components(objective.part)) {
    if (objective.wanted[c.index()]) key.push_back(std::uint64_t{1} << 63 | c.value);
    if (objective.keeps && objective.moved[c.index()]) key.push_back(std::uint64_t{1} << 62 | c.value);
    // Few irreversible steps are permitted, most often none.
    const auto& transitions = graph_.transitions(c);
    for (std::size_t i = 0; i < transitions.size(); ++i) {
      if (NominalGraph::harmless(transitions[i]) || !objective.permitted.on_ways[c.index()][i]) continue;
      const std::uint64_t granted = objective.permitted.granted[c.index()][i] ? 1 : 0;
      key.push_back(std::uint64_t{c.value} << 32 | granted << 31 | i);
    }
  }
  return key;
}

std::optional<IslandPlan> Planner::recall(const Modes& modes, const Objective& objective) {
  if (!objective.keeps_number) return std::nullopt;
  const RememberedStep* const known = remembered_.find(question(modes, objective));
  // What the other parts are in tolerates the action, or no action of this one. Where it does not even tolerate all
  // controls idle, the action is not of this part alone.
  if (known == nullptr || !nominal_.tolerates(modes, idle_) || !nominal_.tolerates(modes, known->action)) {
    return std::nullopt;
  }
  IslandPlan plan{{known->action, known->component, known->serves, {modes, known->moves}, known->idle}, modes};
  for (const NominalMove& move : known->moves) plan.first.outcome.modes[move.component.index()] = move.transition->to;
  for (const ComponentId c : parts_.components(objective.part)) plan.end[c.index()] = known->end[c.index()];
  return plan;
}

std::variant<IslandPlan, Impasse> Planner::planned(const Modes& modes, const Objective& objective) {
  if (auto known = recall(modes, objective)) return std::move(*known);
  const auto plan_of = [](auto& found) -> std::variant<IslandPlan, Impasse> {
    if (auto* const impasse = std::get_if<Impasse>(&found.first)) return std::move(*impasse);
    return IslandPlan{std::get<PlannedStep>(std::move(found.first)), std::move(found.end)};
  };
  Trace trace = follow(modes, objective, Order::commands_first);
  if (trace.safe() && trace.loses) {
    // What has to be achieved twice may be had in fewer steps.
    Found shorter =
        objective.keeps ? search_a_little(modes, objective) : search(modes, objective, Impasse{}, Waits::safe);
    if (std::holds_alternative<PlannedStep>(shorter.first)) return plan_of(shorter);
  }
  if (trace.safe()) return plan_of(trace);
  if (trace.asides) {  // else the walk would be the same
    Trace plain = follow(modes, objective, Order::downstream_first);
    if (plain.safe()) return plan_of(plain);
    if (plain.unsafe < trace.unsafe) trace = std::move(plain);
  }
  const auto* const stuck = std::get_if<Impasse>(&trace.first);
  if (stuck == nullptr) {
    Trace other = follow(modes, objective, Order::lasting_first);
    if (other.safe()) return plan_of(other);
  }
  Found safe = stuck == nullptr ? search(modes, objective, Impasse{}, Waits::grounded)
                                : search(modes, objective, *stuck, Waits::safe);
  if (std::holds_alternative<PlannedStep>(safe.first)) return plan_of(safe);
  if (stuck == nullptr) return plan_of(trace);
  if (!safe.excluded) return plan_of(safe);
  Found any = search(modes, objective, *stuck, Waits::any);
  return plan_of(any);
}

Impasse Planner::turns_in_a_circle(const std::vector<Modes>& states, ComponentId astray,
                                   const Objective& objective) const {
  const automata::Plant& plant = nominal_.plant();
  const Circle circle = circle_in(plant, {std::ranges::find(states, states.back()), states.end()});
  return {astray,
          "the commands that achieve " + name(astray, objective.target[astray.index()]) + " for '" +
              plant[astray].name + "' lead in a circle: " + to_text(circle, plant),
          {.purpose = Reason::Purpose::goal,
           .obstacle = Reason::Obstacle::not_found,
           .component = astray,
           .aim = objective.target[astray.index()],
           .step = circle.back}};
}

Planner::Trace Planner::follow(const Modes& modes, const Objective& objective, Order order) {
  std::vector<Modes> passed;
  std::vector<PlannedStep> taken;  // from each of these
  std::unordered_set<Modes, automata::ModesHash> seen;
  constexpr auto never = std::numeric_limits<std::size_t>::max();
  std::size_t unsafe = 0;
  bool asides = false;
  bool loses = false;
  Modes current = modes;
  while (!arrived(current, objective)) {
    if (!seen.insert(current).second) {
      passed.push_back(current);
      return {turns_in_a_circle(passed, taken.front().component, objective), never, asides, {}};
    }
    // Where a safe walk begins that is known already, the rest is known.
    if (unsafe == 0 && order == Order::commands_first && !taken.empty()) {
      if (auto rest = recall(current, objective)) {
        current = std::move(rest->end);
        break;
      }
    }
    NextStep choice = walk(current, objective, order);
    if (std::holds_alternative<Impasse>(choice)) return {std::move(choice), never, asides, {}};
    auto& step = std::get<PlannedStep>(choice);
    if (order == Order::commands_first && step.idle) {
      if (auto aside = meanwhile(current, objective, step)) {
        step = std::move(*aside);
        asides = true;
      }
    }
    if (!may_take(current, objective, step.action, step.outcome)) {
      return {Impasse{step.component, "what is done beside the goal would not leave it achieved, or would wait"},
              never,
              asides,
              {}};
    }
    unsafe += Reliance(*this, current, objective).is_safe(step.action, step.outcome) ? 0 : 1;
    Modes next = step.outcome.modes;
    for (const ComponentId c : parts_.components(objective.part)) {
      loses = loses || (objective.wanted[c.index()] && !astray(current, objective, c) && astray(next, objective, c));
    }
    // So is what the step before brought about, if it goes by itself: it was of no use so soon.
    if (!taken.empty()) {
      const ComponentId before = taken.back().component;
      loses = loses || (before != step.component && next[before.index()] != current[before.index()]);
    }
    passed.push_back(std::move(current));
    taken.push_back(std::move(step));
    current = std::move(next);
  }
  if (unsafe == 0 && !loses && order == Order::commands_first && objective.keeps_number) {
    for (std::size_t i = 0; i < taken.size(); ++i) {
      const auto& [before, step] = std::tie(passed[i], taken[i]);
      if (!nominal_.tolerates(before, idle_)) continue;  // the action does for other parts, too
      auto key = question(before, objective);
      if (remembered_.find(key) != nullptr) continue;
      remembered_.add(key, {step.action, step.component, step.serves, step.outcome.moves, step.idle, current});
    }
  }
  return {std::move(taken.front()), unsafe, asides, std::move(current), loses};
}

Planner::NextStep Planner::advance(const Modes& modes, const Objective& objective, Order order) {
  std::optional<NextStep> first;
  for (const ComponentId c : ordered_[objective.part]) {
    if (!astray(modes, objective, c)) continue;
    NextStep choice = approach(modes, objective, c);
    const auto* const step = std::get_if<PlannedStep>(&choice);
    if (order != Order::lasting_first) return choice;
    const bool early = step != nullptr && is_brief(*step, objective) && has_waits(step->outcome.modes, objective);
    if (step != nullptr && !early) return choice;
    if (!first) first = std::move(choice);
  }
  CHECK(first && "some component is astray");
  return std::move(*first);
}

Planner::NextStep Planner::walk(const Modes& modes, const Objective& objective, Order order) {
  const auto& components = ordered_[objective.part];
  NextStep choice = advance(modes, objective, order);
  const auto* waiting = std::get_if<PlannedStep>(&choice);
  if (waiting == nullptr || !waiting->idle) return choice;

  // Nothing is served by leaving a fault while time passes: a repair that can be commanded at once goes before a wait.
  for (const ComponentId c : components) {
    if (!astray(modes, objective, c) || !nominal_.plant()[c].modes[modes[c.index()].index()].fault) continue;
    NextStep repair = approach(modes, objective, c);
    const auto* const command = std::get_if<PlannedStep>(&repair);
    if (command != nullptr && !command->idle && command->component == c) return repair;
  }
  return choice;
}

}  // namespace rmpl::runtime
