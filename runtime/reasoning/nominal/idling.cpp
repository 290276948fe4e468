// The tolerated action that is nearest to idle.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/nominal/idling.hpp"

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

/// How many components have to leave their modes at once under an action.
using Leavers = base::FunctionRef<std::size_t(const ControlAction&)>;

/// By control: what the precondition asks of it.
std::vector<const Requirement*> asked_of(const automata::Plant& plant, const Precondition& precondition) {
  std::vector<const Requirement*> asked(plant.controls.size(), nullptr);
  for (std::size_t i = 0; !precondition.empty() && i < asked.size(); ++i) {
    const auto at = std::find_if(precondition.begin(), precondition.end(),
                                 [&](const Requirement& r) { return r.variable == plant.controls[i].variable; });
    if (at != precondition.end()) asked[i] = &*at;
  }
  return asked;
}

/// The controls off idle with their values: actions of as many are in this order.
std::vector<std::pair<std::size_t, automata::ValueId>> order_of(const automata::Plant& plant,
                                                                const ControlAction& action) {
  std::vector<std::pair<std::size_t, automata::ValueId>> result;
  for (std::size_t i = 0; i < action.size(); ++i) {
    if (action[i] != plant.controls[i].idle) result.emplace_back(i, action[i]);
  }
  return result;
}

/// Of the tolerated actions that do as they are asked, one with the fewest controls off idle; of several the one under
/// which the fewest leave, then the first. Looks at up to 4,096.
std::optional<ControlAction> least_of_all(automata::PlantStep& step, const Modes& modes,
                                          const std::vector<const Requirement*>& asked, Leavers leavers) {
  const automata::Plant& plant = step.plant();
  const auto& controls = plant.controls;
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
  ControlAction action = idle_action(plant);
  const auto is_tolerated = [&](std::span<const std::uint32_t> values) -> std::optional<Conflict> {
    for (std::size_t i = 0; i < action.size(); ++i) action[i] = automata::ValueId(values[i]);
    std::vector<automata::Assignment> store = assignments_of(plant, modes);
    const auto commands = assignments_of(plant, action);
    store.insert(store.end(), commands.begin(), commands.end());
    if (step.theory().consistent(store)) return std::nullopt;
    Conflict conflict;
    for (const automata::Assignment& a : step.theory().conflict()) {
      for (std::uint32_t i = 0; i < action.size(); ++i) {
        if (controls[i].variable == a.variable) conflict.push_back({i, values[i]});
      }
    }
    std::sort(conflict.begin(), conflict.end());
    return conflict;
  };
  std::optional<ControlAction> best;
  std::pair<std::size_t, std::vector<std::pair<std::size_t, automata::ValueId>>> least;
  while (search.next(is_tolerated) == OptimalSearch::Outcome::solution) {
    auto order = order_of(plant, action);
    if (best && order.size() > least.second.size()) break;
    std::pair cost(leavers(action), std::move(order));
    if (best && cost > least) continue;
    best = action;
    least = std::move(cost);
  }
  return best;
}

/// But for the component that is to move.
std::size_t leavers_under(automata::PlantStep& step, const Modes& modes, const ControlAction& action,
                          std::optional<ComponentId> moved) {
  const automata::AllEnabled& enabled = step.enabled(modes, action);
  std::size_t result = 0;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const auto& transitions = step.plant()[ComponentId(c)].transitions;
    const auto& untimed = enabled[c].untimed;
    const auto leaves = [&](automata::TransitionId id) { return transitions[id.index()].to != modes[c]; };
    if (moved != ComponentId(c) && std::any_of(untimed.begin(), untimed.end(), leaves)) ++result;
  }
  return result;
}

}  // namespace

ControlAction resting_action(automata::PlantStep& step, const Modes& modes) {
  ControlAction idle = idle_action(step.plant());
  if (step.permits(modes, idle) || !step.possible(modes)) return idle;
  const auto leavers = [&](const ControlAction& a) { return leavers_under(step, modes, a, {}); };
  auto resting = least_of_all(step, modes, asked_of(step.plant(), {}), leavers);
  return resting ? *std::move(resting) : std::move(idle);
}

std::optional<ControlAction> least_action(automata::PlantStep& step, const Modes& modes,
                                          const Precondition& precondition, ComponentId moved) {
  const auto asked = asked_of(step.plant(), precondition);
  ControlAction action = idle_action(step.plant());
  const bool idles = step.permits(modes, action);
  for (std::size_t i = 0; i < action.size(); ++i) {
    if (asked[i] == nullptr) continue;
    const auto& values = asked[i]->values;
    if (!std::binary_search(values.begin(), values.end(), action[i])) action[i] = values.front();
  }
  const auto leavers = [&](const ControlAction& a) { return idles ? 0 : leavers_under(step, modes, a, moved); };
  if (step.permits(modes, action) && leavers(action) == 0) return action;
  return least_of_all(step, modes, asked, leavers);
}

}  // namespace rmpl::runtime
