// The reactive planner: the next step towards a goal state, depth first through the policies.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/planner.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "base/check.hpp"
#include "runtime/reasoning/reconfigure/idling.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::ValueId;

/// Idle; each control of the part off its idle value by itself; then what preconditions need of several at once.
const std::vector<OffIdle>& Planner::actions(std::size_t part) {
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
    : step_(step),
      graph_(graph),
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
  if (plan == nullptr || nominal_.join_others(modes, plan->first.action, objective.part, plan->first.outcome)) {
    return result;
  }
  return Impasse{std::nullopt, "what happens next of itself contradicts the model"};
}

Planner::NextStep Planner::approach(const Modes& modes, const Objective& objective, ComponentId component) {
  NextStep choice = achieve(modes, objective, component, std::span(&objective.target[component.index()], 1));
  if (auto* const step = std::get_if<PlannedStep>(&choice)) {
    step->serves = component;
  } else {
    std::get<Impasse>(choice).serves = component;
  }
  return choice;
}

Planner::NextStep Planner::achieve(const Modes& modes, const Objective& objective, ComponentId component,
                                   std::span<const ModeId> wanted) {
  const Plant& plant = nominal_.plant();
  const ModeId current = modes[component.index()];
  const ModeId* const nearest = nearest_of(modes, objective, component, wanted);
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
  return bring_about(modes, objective, component, *route(modes, objective, component, *nearest).front());
}

const ModeId* Planner::nearest_of(const Modes& modes, const Objective& objective, ComponentId component,
                                  std::span<const ModeId> wanted) {
  const Policy& policy = policies_.of(component, objective.permitted);
  const ModeId current = modes[component.index()];
  const ModeId* nearest = nullptr;
  for (const ModeId& mode : wanted) {
    const auto& distance = policy.distance(current, mode);
    if (distance && (nearest == nullptr || *distance < *policy.distance(current, *nearest))) nearest = &mode;
  }
  return nearest;
}

namespace {

std::vector<ModeId> modes_in(const Requirement& requirement) {
  std::vector<ModeId> result;
  for (const ValueId v : requirement.values) result.emplace_back(v.index());
  return result;
}

}  // namespace

std::optional<Planner::Detour> Planner::detour(const Modes& modes, const Objective& objective, const Way& way) {
  Detour sum;
  for (const ModeRequirement& r : way.modes) {
    if (r.met(modes)) continue;
    const Policy& policy = policies_.of(r.component, objective.permitted);
    // What is not part of the goal state has to be undone again; nothing goes back to a fault.
    const ModeId target = objective.target[r.component.index()];
    const bool stays = nominal_.plant()[r.component].modes[target.index()].fault;
    std::optional<Detour> nearest;
    for (const ValueId v : r.requirement->values) {
      const auto& there = policy.distance(modes[r.component.index()], ModeId(v.index()));
      const auto& back = policy.distance(ModeId(v.index()), target);
      if (!there) continue;
      // What the goal state asks for anyway is no detour.
      const bool anyway = objective.wanted[r.component.index()] && ModeId(v.index()) == target;
      const Detour detour =
          anyway ? Detour{} : Detour{*there + (stays ? Distance{} : back.value_or(Distance{1, 0})), *there};
      if (!nearest || detour < *nearest) nearest = detour;
    }
    if (!nearest) return std::nullopt;
    sum = {sum.and_back + nearest->and_back, sum.there + nearest->there};
  }
  return sum;
}

std::vector<const ModeRequirement*> Planner::pending(const Modes& modes, const Way& way) const {
  std::vector<const ModeRequirement*> result;
  for (const ModeRequirement& r : way.modes) {
    if (!r.met(modes)) result.push_back(&r);
  }
  std::stable_sort(result.begin(), result.end(), [&](const ModeRequirement* a, const ModeRequirement* b) {
    return order_.rank(a->component) < order_.rank(b->component);
  });
  return result;
}

std::size_t Planner::disturbed(const Modes& modes, const Way& way) const {
  std::size_t count = 0;
  for (const ModeRequirement& r : way.modes) {
    if (!r.met(modes)) count += graph_.dependents(r.component).size();
  }
  return count;
}

std::vector<Planner::Choice> Planner::choices(const Modes& modes, const Objective& objective, ComponentId component,
                                              const NominalTransition& next) {
  std::vector<Choice> result;
  for (const NominalTransition& t : graph_.transitions(component)) {
    if (!is_parallel(component, t, next, objective.permitted)) continue;
    for (const Way& way : ways_.of(component, t)) {
      result.push_back({detour(modes, objective, way), disturbed(modes, way), &t, &way});
    }
  }
  std::stable_sort(result.begin(), result.end(), [](const Choice& a, const Choice& b) {
    if (!a.detour || !b.detour) return a.detour.has_value() && !b.detour;
    return std::tuple(*a.detour, a.transition->timed, a.disturbed) <
           std::tuple(*b.detour, b.transition->timed, b.disturbed);
  });
  return result;
}

std::string Planner::would_let(const TransitionOf& refused) const {
  const auto& component = nominal_.plant()[refused.component];
  const auto& t = component.transitions[refused.transition.index()];
  return " would let '" + component.name + "' go from " + name(refused.component, t.from) + " to " +
         name(refused.component, t.to) +
         ", which is irreversible, and the goal does not name a mode that this leads to";
}

/// The step of a way of which only the command is missing.
Planner::NextStep Planner::command(const Modes& modes, const Objective& objective, ComponentId component,
                                   const NominalTransition& transition, const Precondition& precondition) {
  const Plant& plant = nominal_.plant();
  const auto change = [&](ComponentId c, const char* goes, ModeId from, ModeId to) {
    return "'" + plant[c].name + "' " + goes + " from " + name(c, from) + " to " + name(c, to);
  };
  auto action = least_action(step_, modes, precondition, component);
  auto outcome = action
                     ? nominal_.take(modes, *action, {component, &transition}, objective.permitted, &objective.target)
                     : std::nullopt;
  if (outcome) {
    const bool idle = *action == idle_ || *action == resting_action(step_, modes);
    return PlannedStep{std::move(*action), component, component, std::move(*outcome), idle};
  }
  Reason why{.purpose = Reason::Purpose::goal,
             .obstacle = Reason::Obstacle::side_effect,
             .component = component,
             .aim = transition.to,
             .step = TransitionOf{component, transition.id}};
  const std::string purpose = change(component, "to go", transition.from, transition.to);
  if (action && nominal_.refused()) {
    why.obstacle = Reason::Obstacle::forbidden;
    why.step = nominal_.refused();
    return Impasse{component, "what causes " + purpose + would_let(*why.step), why};
  }
  if (action && transition.timed && nominal_.springs_back(modes, *action, component)) {
    why.obstacle = Reason::Obstacle::not_found;
    return Impasse{component,
                   "'" + plant[component].name + "' leaves " + name(component, transition.from) +
                       " at once, before time can take it to " + name(component, transition.to),
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
  std::optional<Impasse> obstacle;
  for (const auto& [detour, disturbed, transition, way] : choices(modes, objective, component, next)) {
    std::optional<NextStep> choice;
    if (const auto lacking = pending(modes, *way); !lacking.empty()) {
      choice = achieve(modes, objective, lacking.front()->component, modes_in(*lacking.front()->requirement));
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

std::optional<PlannedStep> Planner::preparation(const Modes& modes, const Objective& objective, ComponentId component,
                                                std::span<const ModeId> wanted,
                                                base::FunctionRef<bool(const PlannedStep&)> suits) {
  const ModeId* const nearest = nearest_of(modes, objective, component, wanted);
  if (nearest == nullptr || *nearest == modes[component.index()] || order_.in_cycle(component)) return std::nullopt;
  const NominalTransition& next = *route(modes, objective, component, *nearest).front();
  const std::vector<Choice> ways = choices(modes, objective, component, next);
  const auto& [detour, disturbed, transition, way] = ways.front();
  const auto lacking = pending(modes, *way);
  if (lacking.empty()) {
    NextStep step = command(modes, objective, component, *transition, *way->precondition);
    auto* const planned = std::get_if<PlannedStep>(&step);
    return planned != nullptr && !planned->idle && suits(*planned) ? std::optional(std::move(*planned)) : std::nullopt;
  }
  for (const ModeRequirement* const r : lacking) {
    if (auto step = preparation(modes, objective, r->component, modes_in(*r->requirement), suits)) return step;
  }
  return std::nullopt;
}

}  // namespace rmpl::runtime
