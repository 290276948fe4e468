// The reactive planner: the depth-first walk through the policies.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/planner.hpp"

#include <algorithm>
#include <set>
#include <unordered_set>
#include <utility>

#include "base/check.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::ValueId;

/// Idle; each control of the part off its idle value by itself; then what preconditions need of several at once.
const std::vector<Planner::OffIdle>& Planner::actions(std::size_t part) {
  auto& known = actions_[part];
  if (known) return *known;
  const Plant& plant = nominal_.plant();
  std::vector<OffIdle>& all = known.emplace();
  std::set<OffIdle> listed;
  const auto list = [&](OffIdle action) {
    if (listed.insert(action).second) all.push_back(std::move(action));
  };
  list({});
  for (const std::size_t i : parts_.controls(part)) {
    for (std::size_t v = 0; v < plant.variables[plant.controls[i].variable].values.size(); ++v) {
      if (ValueId(v) != idle_[i]) list({{i, ValueId(v)}});
    }
  }
  for (const ComponentId c : parts_.components(part)) {
    for (const NominalTransition& t : graph_.transitions(c)) {
      for (const Precondition& precondition : t.preconditions) {
        std::vector<std::pair<std::size_t, const Requirement*>> asked;
        for (const Requirement& r : precondition) {
          const auto i = index_.control_of(r.variable);
          if (i && !std::binary_search(r.values.begin(), r.values.end(), idle_[*i])) asked.emplace_back(*i, &r);
        }
        std::sort(asked.begin(), asked.end());
        std::vector<OffIdle> joint{{}};
        for (const auto& [i, r] : asked) {
          std::vector<OffIdle> extended;
          for (const OffIdle& action : joint) {
            for (const ValueId v : r->values) extended.emplace_back(action).emplace_back(i, v);
          }
          joint = std::move(extended);
        }
        for (OffIdle& action : joint) list(std::move(action));
      }
    }
  }
  return all;
}

Planner::Planner(automata::PlantStep& step, const NominalGraph& graph, const Parts& parts)
    : graph_(graph),
      parts_(parts),
      order_(step.plant(), graph),
      policies_(step.plant(), graph),
      ways_(step.plant(), graph, order_),
      nominal_(step, graph, parts),
      idle_(idle_action(step.plant())),
      index_(step.plant()),
      ordered_(parts.count()),
      actions_(parts.count()) {
  for (const ComponentId c : order_.downstream_first()) ordered_[parts.of(c)].push_back(c);
}

bool Planner::arrived(const Modes& modes, const Objective& objective) const {
  const auto& components = parts_.components(objective.part);
  return std::all_of(components.begin(), components.end(), [&](ComponentId c) { return !astray(modes, objective, c); });
}

std::string Planner::name(ComponentId component, ModeId mode) const {
  return "'" + nominal_.plant()[component].modes[mode.index()].name + "'";
}

std::variant<IslandPlan, Impasse> Planner::next(const Modes& modes, const Objective& objective) {
  CHECK(!arrived(modes, objective) && "there is something to do");
  auto result = planned(modes, objective);
  auto* const plan = std::get_if<IslandPlan>(&result);
  if (plan == nullptr ||
      nominal_.join_others(modes, plan->first.action, objective.part, objective.permitted, plan->first.outcome)) {
    return result;
  }
  return Impasse{std::nullopt, "what happens next of itself contradicts the model"};
}

bool Planner::may_take(const Objective& objective, const NominalOutcome& outcome) {
  if (!objective.keeps) return true;
  if (!objective.keeps(outcome.modes)) return false;
  return std::all_of(outcome.moves.begin(), outcome.moves.end(), [&](const NominalMove& move) {
    return !move.transition->timed || objective.moved[move.component.index()];
  });
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
      if (NominalGraph::harmless(transitions[i]) || !objective.permitted[c.index()][i]) continue;
      key.push_back(std::uint64_t{c.value} << 32 | i);
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
  if (trace.safe) return plan_of(trace);
  if (trace.asides) {  // else the walk would be the same
    trace = follow(modes, objective, Order::downstream_first);
    if (trace.safe) return plan_of(trace);
  }
  const auto* const stuck = std::get_if<Impasse>(&trace.first);
  if (stuck == nullptr) {
    Trace other = follow(modes, objective, Order::lasting_first);
    if (other.safe) return plan_of(other);
  }
  Found safe = search(modes, objective, stuck == nullptr ? Impasse{} : *stuck, Waits::safe);
  if (std::holds_alternative<PlannedStep>(safe.first)) return plan_of(safe);
  if (stuck == nullptr) return plan_of(trace);
  if (!safe.excluded) return plan_of(safe);
  Found any = search(modes, objective, *stuck, Waits::any);
  return plan_of(any);
}

Planner::Trace Planner::follow(const Modes& modes, const Objective& objective, Order order) {
  std::vector<std::pair<Modes, PlannedStep>> taken;
  std::unordered_set<Modes, automata::ModesHash> seen;
  bool safe = true;
  bool asides = false;
  Modes current = modes;
  while (!arrived(current, objective)) {
    if (!seen.insert(current).second) {
      const ComponentId astray = taken.front().second.component;
      return {Impasse{astray,
                      "the commands that achieve " + name(astray, objective.target[astray.index()]) + " for '" +
                          nominal_.plant()[astray].name + "' lead in a circle",
                      {.purpose = Reason::Purpose::goal,
                       .obstacle = Reason::Obstacle::not_found,
                       .component = astray,
                       .aim = objective.target[astray.index()]}},
              false,
              asides,
              {}};
    }
    // Where a safe walk begins that is known already, the rest is known.
    if (safe && order == Order::commands_first && !taken.empty()) {
      if (auto rest = recall(current, objective)) {
        current = std::move(rest->end);
        break;
      }
    }
    NextStep choice = walk(current, objective, order);
    if (std::holds_alternative<Impasse>(choice)) return {std::move(choice), false, asides, {}};
    auto& step = std::get<PlannedStep>(choice);
    if (order == Order::commands_first && step.idle) {
      if (auto aside = meanwhile(current, objective, step)) {
        step = std::move(*aside);
        asides = true;
      }
    }
    if (!may_take(objective, step.outcome)) {
      return {Impasse{step.component, "what is done beside the goal would not leave it achieved, or would wait"},
              false,
              asides,
              {}};
    }
    safe = safe && is_safe(current, objective, step.action, step.outcome);
    Modes next = step.outcome.modes;
    taken.emplace_back(std::move(current), std::move(step));
    current = std::move(next);
  }
  if (safe && order == Order::commands_first && objective.keeps_number) {
    for (const auto& [before, step] : taken) {
      if (!nominal_.tolerates(before, idle_)) continue;  // the action does for other parts, too
      auto key = question(before, objective);
      if (remembered_.find(key) != nullptr) continue;
      remembered_.add(key, {step.action, step.component, step.serves, step.outcome.moves, step.idle, current});
    }
  }
  return {std::move(taken.front().second), safe, asides, std::move(current)};
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

Planner::NextStep Planner::approach(const Modes& modes, const Objective& objective, ComponentId component) {
  NextStep choice = achieve(modes, objective, component, std::span(&objective.target[component.index()], 1));
  if (auto* const step = std::get_if<PlannedStep>(&choice)) step->serves = component;
  return choice;
}

Planner::NextStep Planner::achieve(const Modes& modes, const Objective& objective, ComponentId component,
                                   std::span<const ModeId> wanted) {
  const Plant& plant = nominal_.plant();
  const ModeId current = modes[component.index()];
  const Policy& policy = policies_.of(component, objective.permitted);
  const ModeId* nearest = nullptr;
  for (const ModeId& mode : wanted) {
    const auto& distance = policy.distance(current, mode);
    if (distance && (nearest == nullptr || *distance < *policy.distance(current, *nearest))) nearest = &mode;
  }
  if (nearest == nullptr) {
    return Impasse{component,
                   "no permitted nominal transitions lead '" + plant[component].name + "' from " +
                       name(component, current) + " to " + name(component, wanted.front()),
                   {.purpose = Reason::Purpose::goal,
                    .obstacle = Reason::Obstacle::missing,
                    .component = component,
                    .aim = wanted.front()}};
  }
  if (order_.in_cycle(component)) {
    return Impasse{component,
                   "no permitted sequence of commands leads '" + plant[component].name + "' from " +
                       name(component, current) + " to " + name(component, *nearest),
                   {.purpose = Reason::Purpose::goal,
                    .obstacle = Reason::Obstacle::not_found,
                    .component = component,
                    .aim = *nearest}};
  }
  return bring_about(modes, objective, component, *policy.next(current, *nearest));
}

namespace {

bool is_met(const ModeRequirement& r, const Modes& modes) {
  const auto& values = r.requirement->values;
  return std::binary_search(values.begin(), values.end(), ValueId(modes[r.component.index()].index()));
}

}  // namespace

std::optional<Distance> Planner::distance(const Modes& modes, const Objective& objective, const Way& way) {
  Distance sum;
  for (const ModeRequirement& r : way.modes) {
    if (is_met(r, modes)) continue;
    const Policy& policy = policies_.of(r.component, objective.permitted);
    // What is not part of the goal state has to be undone again.
    const ModeId target = objective.target[r.component.index()];
    std::optional<Distance> nearest;
    for (const ValueId v : r.requirement->values) {
      const auto& there = policy.distance(modes[r.component.index()], ModeId(v.index()));
      const auto& back = policy.distance(ModeId(v.index()), target);
      if (!there) continue;
      const Distance distance = *there + back.value_or(Distance{1, 0});
      if (!nearest || distance < *nearest) nearest = distance;
    }
    if (!nearest) return std::nullopt;
    sum = sum + *nearest;
  }
  return sum;
}

const ModeRequirement* Planner::first_pending(const Modes& modes, const Way& way) const {
  const ModeRequirement* first = nullptr;
  for (const ModeRequirement& r : way.modes) {
    if (is_met(r, modes)) continue;
    if (first == nullptr || order_.rank(r.component) < order_.rank(first->component)) first = &r;
  }
  return first;
}

/// The step of a way of which only the command is missing.
Planner::NextStep Planner::command(const Modes& modes, const Objective& objective, ComponentId component,
                                   const NominalTransition& transition, const Precondition& precondition) {
  const Plant& plant = nominal_.plant();
  const auto change = [&](ComponentId c, const char* goes, ModeId from, ModeId to) {
    return "'" + plant[c].name + "' " + goes + " from " + name(c, from) + " to " + name(c, to);
  };
  auto action = nominal_.least_action(modes, &precondition);
  auto outcome = action
                     ? nominal_.take(modes, *action, {component, &transition}, objective.permitted, &objective.target)
                     : std::nullopt;
  if (outcome) {
    const bool idle =
        *action == idle_ || (!nominal_.tolerates(modes, idle_) && action == nominal_.resting_action(modes));
    return PlannedStep{std::move(*action), component, component, std::move(*outcome), idle};
  }
  Reason why{.purpose = Reason::Purpose::goal,
             .obstacle = Reason::Obstacle::side_effect,
             .component = component,
             .aim = transition.to,
             .step = TransitionOf{component, transition.id}};
  const std::string purpose = change(component, "to go", transition.from, transition.to);
  if (action && nominal_.refused()) {
    const TransitionOf refused = *nominal_.refused();
    const auto& t = plant[refused.component].transitions[refused.transition.index()];
    why.obstacle = Reason::Obstacle::forbidden;
    why.step = refused;
    return Impasse{component,
                   "what causes " + purpose + " would let " + change(refused.component, "go", t.from, t.to) +
                       ", which is irreversible, and the goal does not name a mode that this leads to",
                   why};
  }
  return Impasse{component, "every command that would cause " + purpose + " undoes what is achieved", why};
}

Planner::NextStep Planner::bring_about(const Modes& modes, const Objective& objective, ComponentId component,
                                       const NominalTransition& next) {
  const auto purpose = [&] {
    return "'" + nominal_.plant()[component].name + "' to go from " + name(component, next.from) + " to " +
           name(component, next.to);
  };
  struct Choice {
    std::optional<Distance> distance;
    const NominalTransition* transition;
    const Way* way;
  };
  std::vector<Choice> choices;
  for (const NominalTransition& t : graph_.transitions(component)) {
    if (!is_parallel(component, t, next, objective.permitted)) continue;
    for (const Way& way : ways_.of(component, t)) choices.push_back({distance(modes, objective, way), &t, &way});
  }
  std::stable_sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) {
    if (!a.distance || !b.distance) return a.distance.has_value() && !b.distance;
    return std::pair(*a.distance, a.transition->timed) < std::pair(*b.distance, b.transition->timed);
  });

  std::optional<Impasse> obstacle;
  for (const auto& [distance, transition, way] : choices) {
    std::optional<NextStep> choice;
    if (const ModeRequirement* const pending = first_pending(modes, *way)) {
      std::vector<ModeId> wanted;
      for (const ValueId v : pending->requirement->values) wanted.emplace_back(v.index());
      choice = achieve(modes, objective, pending->component, wanted);
      if (auto* stuck = std::get_if<Impasse>(&*choice)) stuck->reason += ", as it takes for " + purpose();
    } else {
      choice = command(modes, objective, component, *transition, *way->precondition);
    }
    if (std::holds_alternative<PlannedStep>(*choice)) return std::move(*choice);
    if (!obstacle) obstacle = std::get<Impasse>(std::move(*choice));
  }
  CHECK(obstacle && "a transition in the graph has a precondition");
  return *obstacle;
}

}  // namespace rmpl::runtime
