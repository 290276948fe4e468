// The cone of influence.
// SPDX-License-Identifier: MIT
#include "verifier/slice/cone.hpp"

#include <algorithm>

namespace rmpl::verifier {

using automata::ComponentId;
using automata::ControlAction;
using automata::Island;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::PlantStep;
using automata::ValueId;

namespace {

/// Up to so many combinations of modes and controls of an island are looked at; more are taken to hold a contradiction.
constexpr std::size_t most_combinations = 4096;

/// Whether no control action contradicts the island in modes that are possible there.
bool indifferent(PlantStep& step, const Island& island) {
  const Plant& plant = step.plant();
  std::size_t combinations = 1;
  const auto times = [&](std::size_t values) { combinations = std::min(combinations * values, most_combinations + 1); };
  for (const ComponentId c : island.support.components) times(plant[c].modes.size());
  for (const std::size_t i : island.support.controls) times(plant.variables[plant.controls[i].variable].values.size());
  if (combinations > most_combinations) return false;
  for (std::size_t number = 0; number < combinations; ++number) {
    std::size_t rest = number;
    const auto digit = [&](std::size_t values) {
      const std::size_t value = rest % values;
      rest /= values;
      return ValueId(value);
    };
    std::vector<automata::Assignment> store;
    for (const ComponentId c : island.support.components)
      store.push_back({plant[c].mode, digit(plant[c].modes.size())});
    if (!step.theory().consistent(store)) continue;
    for (const std::size_t i : island.support.controls) {
      const automata::VariableId control = plant.controls[i].variable;
      store.push_back({control, digit(plant.variables[control].values.size())});
    }
    if (!step.theory().consistent(store)) return false;
  }
  return true;
}

}  // namespace

std::vector<bool> cone_of_influence(PlantStep& step, std::span<const automata::Formula> formulas) {
  const Plant& plant = step.plant();
  std::vector<bool> inside(plant.components.size(), false);
  std::vector<ComponentId> waiting;
  const auto add = [&](const automata::Support& support) {
    for (const ComponentId c : support.components) {
      if (!inside[c.index()]) waiting.push_back(c);
      inside[c.index()] = true;
    }
  };
  for (const automata::Formula& formula : formulas) add(step.locality().support_of(formula));
  for (const Island& island : step.locality().islands()) {
    if (!island.constraints.empty() && !island.support.controls.empty() && !indifferent(step, island))
      add(island.support);
  }
  while (!waiting.empty()) {
    const ComponentId c = waiting.back();
    waiting.pop_back();
    for (std::size_t m = 0; m < plant[c].modes.size(); ++m) add(step.support(c, ModeId(m)));
    for (const Island& island : step.locality().islands()) {
      if (!island.constraints.empty() && island.support.reads(c)) add(island.support);
    }
  }
  return inside;
}

}  // namespace rmpl::verifier
