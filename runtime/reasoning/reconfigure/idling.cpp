// The tolerated action that is nearest to idle.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/idling.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "base/function_ref.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::Modes;

namespace {

using Suits = base::FunctionRef<bool(const ControlAction&)>;

std::optional<ControlAction> least_action(automata::PlantStep& step, const Modes& modes,
                                          const Precondition& precondition, Suits suits) {
  const automata::Plant& plant = step.plant();
  const auto& controls = plant.controls;
  ControlAction action = idle_action(plant);
  std::vector<const Requirement*> asked(controls.size(), nullptr);
  for (std::size_t i = 0; !precondition.empty() && i < asked.size(); ++i) {
    const auto at = std::find_if(precondition.begin(), precondition.end(),
                                 [&](const Requirement& r) { return r.variable == controls[i].variable; });
    if (at == precondition.end()) continue;
    asked[i] = &*at;
    if (!std::binary_search(at->values.begin(), at->values.end(), action[i])) action[i] = at->values.front();
  }
  if (step.permits(modes, action) && suits(action)) return action;
  OptimalSearch::Costs costs;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    auto& cost = costs.emplace_back(plant.variables[controls[i].variable].values.size(), 1.0);
    cost[controls[i].idle.index()] = 0;
    for (std::size_t v = 0; v < cost.size() && asked[i] != nullptr; ++v) {
      if (std::binary_search(asked[i]->values.begin(), asked[i]->values.end(), automata::ValueId(v))) continue;
      cost[v] = std::numeric_limits<double>::infinity();
    }
  }
  OptimalSearch search(costs);
  constexpr std::size_t action_limit = 1u << 12;
  search.set_budget(action_limit);
  const auto outcome = search.next([&](std::span<const std::uint32_t> values) -> std::optional<Conflict> {
    for (std::size_t i = 0; i < action.size(); ++i) action[i] = automata::ValueId(values[i]);
    std::vector<automata::Assignment> store = assignments_of(plant, modes);
    const auto commands = assignments_of(plant, action);
    store.insert(store.end(), commands.begin(), commands.end());
    Conflict conflict;
    if (step.theory().consistent(store)) {
      if (suits(action)) return std::nullopt;
      for (std::uint32_t i = 0; i < action.size(); ++i) conflict.push_back({i, values[i]});
      return conflict;
    }
    for (const automata::Assignment& a : step.theory().conflict()) {
      for (std::uint32_t i = 0; i < action.size(); ++i) {
        if (controls[i].variable == a.variable) conflict.push_back({i, values[i]});
      }
    }
    std::sort(conflict.begin(), conflict.end());
    return conflict;
  });
  if (outcome != OptimalSearch::Outcome::solution) return std::nullopt;
  return action;
}

constexpr auto any = [](const ControlAction&) { return true; };

}  // namespace

std::optional<ControlAction> least_action(automata::PlantStep& step, const Modes& modes,
                                          const Precondition& precondition) {
  return least_action(step, modes, precondition, any);
}

ControlAction resting_action(automata::PlantStep& step, const Modes& modes) {
  ControlAction idle = idle_action(step.plant());
  if (step.permits(modes, idle) || !step.possible(modes)) return idle;
  const auto rests = [&](const ControlAction& action) {
    const automata::AllEnabled& enabled = step.enabled(modes, action);
    for (std::size_t c = 0; c < modes.size(); ++c) {
      const auto& transitions = step.plant()[ComponentId(c)].transitions;
      const auto& untimed = enabled[c].untimed;
      const auto leaves = [&](automata::TransitionId id) { return transitions[id.index()].to != modes[c]; };
      if (std::any_of(untimed.begin(), untimed.end(), leaves)) return false;
    }
    return true;
  };
  auto resting = least_action(step, modes, {}, rests);
  if (!resting) resting = least_action(step, modes, {}, any);
  return resting ? *std::move(resting) : std::move(idle);
}

Reconfiguration at_rest(automata::PlantStep& step, const Modes& modes) {
  Reconfiguration result;
  result.action = resting_action(step, modes);
  if (result.action == idle_action(step.plant())) return result;
  result.outcome = Reconfiguration::Outcome::command;
  result.expected = modes;
  result.why.purpose = Reason::Purpose::model;
  return result;
}

}  // namespace rmpl::runtime
