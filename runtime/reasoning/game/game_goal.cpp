// A goal, what it reads, and what it licenses.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/game_goal.hpp"

#include <algorithm>
#include <utility>

#include "automata/owner.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Formula;
using automata::Modes;

GameGoal::GameGoal(const Formula& goal, automata::PlantStep& step, const NominalGraph& graph)
    : step_(step), formula_(goal), reads_(step.plant().components.size()) {
  const automata::Plant& plant = step.plant();
  for (Formula& conjunct : conjuncts_of(goal)) {
    Part& part = parts_.emplace_back(Part{std::move(conjunct), true, {}, {}});
    part.reads = step.locality().support_of(part.formula).components;
    for (const automata::VariableId v : variables_of(part.formula)) {
      part.about_modes = part.about_modes && plant.component_of(v).has_value();
    }
    if (!part.about_modes) part.handle = step.theory().encode(part.formula);
    for (const automata::VariableId v : variables_of(part.formula)) {
      if (const auto owner = automata::owner_of(plant, v)) reads_[owner->index()] = true;
    }
  }
  const NamedModes named = named_modes(plant, goal);
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    auto& licensed = licensed_.emplace_back();
    for (const automata::Transition& t : plant.components[c].transitions) {
      licensed.push_back(graph.leads_to_named(ComponentId(c), t.to, named));
    }
  }
}

std::vector<WantedModes> GameGoal::wanted(std::size_t part) const {
  const automata::Plant& plant = step_.plant();
  const NamedModes named = named_modes(plant, parts_[part].formula);
  std::vector<WantedModes> result;
  for (const ComponentId c : parts_[part].reads) {
    const std::vector<bool>& names = named[c.index()];
    const bool any = std::find(names.begin(), names.end(), true) != names.end();
    for (std::size_t m = 0; m < names.size(); ++m) {
      if (any && !names[m]) continue;
      result.emplace_back(c, std::vector<bool>(names.size())).second[m] = true;
    }
  }
  return result;
}

std::vector<bool> GameGoal::held(const Modes& modes, const std::vector<std::size_t>& parts) const {
  const automata::Plant& plant = step_.plant();
  std::vector<bool> result;
  result.reserve(parts.size());
  std::vector<automata::Assignment> now;
  for (const std::size_t p : parts) {
    const Part& part = parts_[p];
    if (part.about_modes) {
      result.push_back(evaluate(part.formula, [&](automata::VariableId v) {
        return automata::ValueId(modes[plant.component_of(v)->index()].index());
      }));
      continue;
    }
    if (now.empty()) now = assignments_of(plant, modes);
    result.push_back(step_.theory().entails(now, part.handle));
  }
  return result;
}

}  // namespace rmpl::runtime
