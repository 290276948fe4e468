// The reactive planner: the depth-first walk through the policies.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/planner.hpp"

#include <algorithm>
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

namespace {

/// Idle; each control of the island off its idle value by itself; then what supports need of several at once.
std::vector<ControlAction> actions_of(const Plant& plant, const NominalGraph& graph, const Islands& islands,
                                      std::size_t island) {
  const ControlAction idle = idle_action(plant);
  std::vector<ControlAction> actions{idle};
  for (const std::size_t i : islands.controls(island)) {
    for (std::size_t v = 0; v < plant.variables[plant.controls[i].variable].values.size(); ++v) {
      if (ValueId(v) == idle[i]) continue;
      actions.push_back(idle);
      actions.back()[i] = ValueId(v);
    }
  }
  for (const ComponentId c : islands.components(island)) {
    for (const NominalTransition& t : graph.transitions(c)) {
      for (const Support& support : t.supports) {
        std::vector<ControlAction> joint{idle};
        for (const std::size_t i : islands.controls(island)) {
          const auto r = std::find_if(support.begin(), support.end(), [&](const Requirement& requirement) {
            return requirement.variable == plant.controls[i].variable;
          });
          if (r == support.end() || std::binary_search(r->values.begin(), r->values.end(), idle[i])) continue;
          std::vector<ControlAction> extended;
          for (const ControlAction& action : joint) {
            for (const ValueId v : r->values) extended.emplace_back(action)[i] = v;
          }
          joint = std::move(extended);
        }
        for (ControlAction& action : joint) {
          if (std::find(actions.begin(), actions.end(), action) == actions.end()) actions.push_back(std::move(action));
        }
      }
    }
  }
  return actions;
}

}  // namespace

Planner::Planner(automata::PlantStep& step, const NominalGraph& graph, const Islands& islands)
    : graph_(graph),
      islands_(islands),
      order_(step.plant(), graph),
      policies_(step.plant(), graph),
      ways_(step.plant(), graph, order_),
      nominal_(step, graph, islands),
      idle_(idle_action(step.plant())),
      component_of_(step.plant().variables.size()),
      ordered_(islands.count()) {
  const Plant& plant = step.plant();
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    component_of_[plant.components[c].mode.index()] = ComponentId(c);
  }
  for (const ComponentId c : order_.downstream_first()) ordered_[islands.of(c)].push_back(c);
  for (std::size_t i = 0; i < islands.count(); ++i) actions_.push_back(actions_of(plant, graph, islands, i));
}

bool Planner::arrived(const Modes& modes, const Objective& objective) const {
  const auto& components = islands_.components(objective.island);
  return std::all_of(components.begin(), components.end(),
                     [&](ComponentId c) { return modes[c.index()] == objective.target[c.index()]; });
}

std::string Planner::name(ComponentId component, ModeId mode) const {
  return "'" + nominal_.plant()[component].modes[mode.index()].name + "'";
}

Planner::Choice Planner::next(const Modes& modes, const Objective& objective) {
  CHECK(!arrived(modes, objective) && "there is something to do");
  Choice choice = first_step(modes, objective);
  auto* const step = std::get_if<PlannedStep>(&choice);
  if (step == nullptr || nominal_.join_others(modes, step->action, objective.island, objective.named, step->outcome)) {
    return choice;
  }
  return Impasse{std::nullopt, "what happens next of itself contradicts the model"};
}

std::vector<std::uint64_t> Planner::question(const Modes& modes, const Objective& objective) const {
  std::vector<std::uint64_t> key{objective.island};
  for (const ComponentId c : islands_.components(objective.island)) {
    key.push_back(std::uint64_t{modes[c.index()].value} << 32 | objective.target[c.index()].value);
  }
  // Few modes are named, most often none but targets.
  for (const ComponentId c : islands_.components(objective.island)) {
    const std::vector<bool>& named = objective.named[c.index()];
    for (auto at = std::find(named.begin(), named.end(), true); at != named.end();
         at = std::find(at + 1, named.end(), true)) {
      key.push_back(std::uint64_t{c.value} << 32 | static_cast<std::uint32_t>(at - named.begin()));
    }
  }
  return key;
}

std::optional<PlannedStep> Planner::recall(const Modes& modes, const Objective& objective) {
  const RememberedStep* const known = remembered_.find(question(modes, objective));
  // What the other islands are in tolerates the action, or no action of this one.
  if (known == nullptr || !nominal_.tolerates(modes, known->action)) return std::nullopt;
  PlannedStep step{known->action, known->component, {modes, known->moves}, known->idle};
  for (const NominalMove& move : known->moves) step.outcome.modes[move.component.index()] = move.transition->to;
  return step;
}

Planner::Choice Planner::first_step(const Modes& modes, const Objective& objective) {
  if (auto known = recall(modes, objective)) return std::move(*known);
  Trace trace = follow(modes, objective, Order::downstream_first);
  if (trace.safe) return std::move(trace.first);
  auto* const stuck = std::get_if<Impasse>(&trace.first);
  if (stuck == nullptr) {
    Trace other = follow(modes, objective, Order::lasting_first);
    if (other.safe) return std::move(other.first);
  }
  Found safe = search(modes, objective, stuck == nullptr ? Impasse{} : *stuck, Waits::safe);
  if (std::holds_alternative<PlannedStep>(safe.first)) return std::move(safe.first);
  if (stuck == nullptr) return std::move(trace.first);
  if (!safe.excluded) return std::move(safe.first);
  return search(modes, objective, *stuck, Waits::any).first;
}

Planner::Trace Planner::follow(const Modes& modes, const Objective& objective, Order order) {
  std::vector<std::pair<Modes, PlannedStep>> taken;
  std::unordered_set<Modes, automata::ModesHash> seen;
  bool safe = true;
  Modes current = modes;
  while (!arrived(current, objective)) {
    if (!seen.insert(current).second) {
      const ComponentId astray = taken.front().second.component;
      return {Impasse{astray, "the commands that achieve " + name(astray, objective.target[astray.index()]) + " for '" +
                                  nominal_.plant()[astray].name + "' lead in a circle"},
              false};
    }
    // Where a safe walk begins that is known already, the rest is known.
    if (safe && order == Order::downstream_first && !taken.empty() && recall(current, objective)) break;
    Choice choice = walk(current, objective, order);
    if (std::holds_alternative<Impasse>(choice)) return {std::move(choice), false};
    auto& step = std::get<PlannedStep>(choice);
    safe = safe && is_safe(current, objective, step.action, step.outcome);
    Modes next = step.outcome.modes;
    taken.emplace_back(std::move(current), std::move(step));
    current = std::move(next);
  }
  if (safe && order == Order::downstream_first) {
    for (const auto& [before, step] : taken) {
      auto key = question(before, objective);
      if (remembered_.find(key) != nullptr) continue;
      remembered_.add(key, {step.action, step.component, step.outcome.moves, step.idle});
    }
  }
  return {std::move(taken.front().second), safe};
}

Planner::Choice Planner::advance(const Modes& modes, const Objective& objective, Order order) {
  std::optional<Choice> first;
  for (const ComponentId c : ordered_[objective.island]) {
    if (modes[c.index()] == objective.target[c.index()]) continue;
    Choice choice = achieve(modes, objective, c, std::span(&objective.target[c.index()], 1));
    const auto* const step = std::get_if<PlannedStep>(&choice);
    if (order == Order::downstream_first) return choice;
    const bool early = step != nullptr && is_brief(*step, objective) && has_waits(step->outcome.modes, objective);
    if (step != nullptr && !early) return choice;
    if (!first) first = std::move(choice);
  }
  CHECK(first && "some component is astray");
  return std::move(*first);
}

Planner::Choice Planner::walk(const Modes& modes, const Objective& objective, Order order) {
  const auto& components = ordered_[objective.island];
  Choice choice = advance(modes, objective, order);
  const auto* waiting = std::get_if<PlannedStep>(&choice);
  if (waiting == nullptr || !waiting->idle) return choice;

  // Nothing is served by leaving a fault while time passes: a repair that can be commanded at once goes before a wait.
  for (const ComponentId c : components) {
    const ModeId target = objective.target[c.index()];
    if (modes[c.index()] == target || !nominal_.plant()[c].modes[modes[c.index()].index()].fault) continue;
    Choice repair = achieve(modes, objective, c, std::span(&target, 1));
    const auto* command = std::get_if<PlannedStep>(&repair);
    if (command != nullptr && !command->idle && command->component == c) return repair;
  }
  return choice;
}

Planner::Choice Planner::achieve(const Modes& modes, const Objective& objective, ComponentId component,
                                 std::span<const ModeId> wanted) {
  const Plant& plant = nominal_.plant();
  const ModeId current = modes[component.index()];
  const Policy& policy = policies_.of(component, objective.named);
  const ModeId* nearest = nullptr;
  for (const ModeId& mode : wanted) {
    const auto& distance = policy.distance(current, mode);
    if (distance && (nearest == nullptr || *distance < *policy.distance(current, *nearest))) nearest = &mode;
  }
  if (nearest == nullptr) {
    return Impasse{component, "no permitted nominal transitions lead '" + plant[component].name + "' from " +
                                  name(component, current) + " to " + name(component, wanted.front())};
  }
  if (order_.in_cycle(component)) {
    return Impasse{component, "no permitted sequence of commands leads '" + plant[component].name + "' from " +
                                  name(component, current) + " to " + name(component, *nearest)};
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
    const Policy& policy = policies_.of(r.component, objective.named);
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

ControlAction Planner::action_for(const Support& support) const {
  const auto& controls = nominal_.plant().controls;
  ControlAction action = idle_;
  for (const Requirement& r : support) {
    for (std::size_t i = 0; i < controls.size(); ++i) {
      if (controls[i].variable != r.variable) continue;
      if (!std::binary_search(r.values.begin(), r.values.end(), idle_[i])) action[i] = r.values.front();
    }
  }
  return action;
}

Planner::Choice Planner::bring_about(const Modes& modes, const Objective& objective, ComponentId component,
                                     const NominalTransition& transition) {
  const auto purpose = [&] {
    return "'" + nominal_.plant()[component].name + "' to go from " + name(component, transition.from) + " to " +
           name(component, transition.to);
  };
  std::vector<std::pair<std::optional<Distance>, const Way*>> ways;
  for (const Way& way : ways_.of(component, transition)) ways.emplace_back(distance(modes, objective, way), &way);
  std::stable_sort(ways.begin(), ways.end(), [](const auto& a, const auto& b) {
    if (!a.first || !b.first) return a.first.has_value() && !b.first;
    return *a.first < *b.first;
  });

  std::optional<Impasse> obstacle;
  for (const auto& [distance, way] : ways) {
    std::optional<Choice> choice;
    if (const ModeRequirement* const pending = first_pending(modes, *way)) {
      std::vector<ModeId> wanted;
      for (const ValueId v : pending->requirement->values) wanted.emplace_back(v.index());
      choice = achieve(modes, objective, pending->component, wanted);
      if (auto* stuck = std::get_if<Impasse>(&*choice)) stuck->reason += ", as it takes for " + purpose();
    } else {
      ControlAction action = action_for(*way->support);
      auto outcome = nominal_.take(modes, action, {component, &transition}, objective.named, &objective.target);
      if (outcome) {
        const bool idle = action == idle_;
        choice = PlannedStep{std::move(action), component, std::move(*outcome), idle};
      } else {
        choice = Impasse{component, "every command that would cause " + purpose() +
                                        " undoes what is achieved, or takes an irreversible step that the goal does "
                                        "not name"};
      }
    }
    if (std::holds_alternative<PlannedStep>(*choice)) return std::move(*choice);
    if (!obstacle) obstacle = std::get<Impasse>(std::move(*choice));
  }
  CHECK(obstacle && "a transition in the graph has a support");
  return *obstacle;
}

}  // namespace rmpl::runtime
