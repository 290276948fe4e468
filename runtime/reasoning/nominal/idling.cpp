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

using Suits = base::FunctionRef<bool(const ControlAction&)>;

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

/// Of the tolerated actions that suit and do as they are asked, the one with the fewest controls off idle, of several
/// the first by values.
std::optional<ControlAction> least_of_all(automata::PlantStep& step, const Modes& modes,
                                          const std::vector<const Requirement*>& asked, Suits suits) {
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

/// Whether no untimed transition changes a mode, but of the component that is to move.
bool rests(automata::PlantStep& step, const Modes& modes, const ControlAction& action,
           std::optional<ComponentId> moved) {
  const automata::AllEnabled& enabled = step.enabled(modes, action);
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const auto& transitions = step.plant()[ComponentId(c)].transitions;
    const auto& untimed = enabled[c].untimed;
    const auto leaves = [&](automata::TransitionId id) { return transitions[id.index()].to != modes[c]; };
    if (moved != ComponentId(c) && std::any_of(untimed.begin(), untimed.end(), leaves)) return false;
  }
  return true;
}

}  // namespace

ControlAction resting_action(automata::PlantStep& step, const Modes& modes) {
  ControlAction idle = idle_action(step.plant());
  if (step.permits(modes, idle) || !step.possible(modes)) return idle;
  const auto asked = asked_of(step.plant(), {});
  auto resting = least_of_all(step, modes, asked, [&](const ControlAction& a) { return rests(step, modes, a, {}); });
  if (!resting) resting = least_of_all(step, modes, asked, any);
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
  const auto others_rest = [&](const ControlAction& a) { return idles || rests(step, modes, a, moved); };
  if (step.permits(modes, action) && others_rest(action)) return action;
  auto least = idles ? std::nullopt : least_of_all(step, modes, asked, others_rest);
  return least ? std::move(least) : least_of_all(step, modes, asked, any);
}

}  // namespace rmpl::runtime
