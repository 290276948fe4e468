// What follows from what, by looking at every assignment of the variables.
// SPDX-License-Identifier: MIT
#include "tests/reference/models.hpp"

#include <algorithm>

namespace rmpl::reference {

using automata::Assignment;
using automata::Formula;

namespace {

bool compare(automata::Ticks reading, automata::Comparison comparison, automata::Ticks bound) {
  switch (comparison) {
    case automata::Comparison::less:
      return reading < bound;
    case automata::Comparison::at_most:
      return reading <= bound;
    case automata::Comparison::greater:
      return reading > bound;
    case automata::Comparison::at_least:
      return reading >= bound;
  }
  return false;
}

std::vector<World> all_worlds(const automata::Variables& variables) {
  std::vector<std::size_t> sizes;
  for (const automata::Variable& variable : variables) sizes.push_back(variable.values.size());
  std::vector<World> worlds;
  for (const auto& tuple : tuples(sizes)) {
    World& world = worlds.emplace_back();
    for (std::size_t value : tuple) world.emplace_back(value);
  }
  return worlds;
}

bool permitted(const automata::Plant& plant, const World& world) {
  for (const automata::Interconnection& q : plant.interconnections)
    if (!holds(q.constraint, world)) return false;
  for (const automata::Component& component : plant.components) {
    const automata::ValueId mode = world[component.mode.index()];
    if (!holds(component.modes[mode.index()].constraint, world)) return false;
  }
  return true;
}

}  // namespace

std::vector<std::vector<std::size_t>> tuples(const std::vector<std::size_t>& sizes) {
  std::vector<std::vector<std::size_t>> result = {{}};
  for (std::size_t size : sizes) {
    std::vector<std::vector<std::size_t>> longer;
    for (const auto& prefix : result)
      for (std::size_t i = 0; i < size; ++i) {
        longer.push_back(prefix);
        longer.back().push_back(i);
      }
    result = std::move(longer);
  }
  return result;
}

bool holds(const Formula& formula, const World& world, const Clocks& clocks) {
  const auto operand = [&](std::size_t i) { return holds(formula.operands[i], world, clocks); };
  switch (formula.kind) {
    case Formula::Kind::constant:
      return formula.truth;
    case Formula::Kind::member:
      return std::count(formula.values.begin(), formula.values.end(), world[formula.variable.index()]) > 0;
    case Formula::Kind::equality:
      return world[formula.variable.index()] == world[formula.other.index()];
    case Formula::Kind::clock: {
      const auto& reading = clocks.at(formula.clock.index());
      return reading && compare(*reading, formula.comparison, formula.bound);
    }
    case Formula::Kind::knowledge:
      return false;  // replaced before by who asks
    case Formula::Kind::negation:
      return !operand(0);
    case Formula::Kind::conjunction:
      for (std::size_t i = 0; i < formula.operands.size(); ++i)
        if (!operand(i)) return false;
      return true;
    case Formula::Kind::disjunction:
      for (std::size_t i = 0; i < formula.operands.size(); ++i)
        if (operand(i)) return true;
      return false;
    case Formula::Kind::implication:
      return !operand(0) || operand(1);
    case Formula::Kind::equivalence:
      return operand(0) == operand(1);
  }
  return false;
}

Models::Models(const automata::Plant& plant) {
  for (World& world : all_worlds(plant.variables))
    if (permitted(plant, world)) worlds_.push_back(std::move(world));
}

Models::Models(const automata::Variables& variables) : worlds_(all_worlds(variables)) {}

const std::vector<const World*>& Models::matching(std::vector<Assignment> assumptions) const {
  std::sort(assumptions.begin(), assumptions.end());
  const auto [place, first_time] = matching_.try_emplace(assumptions);
  if (first_time)
    for (const World& world : worlds_)
      if (std::all_of(assumptions.begin(), assumptions.end(),
                      [&](Assignment a) { return world[a.variable.index()] == a.value; }))
        place->second.push_back(&world);
  return place->second;
}

bool Models::consistent(const std::vector<Assignment>& assumptions) const { return !matching(assumptions).empty(); }

bool Models::allows(const std::vector<Assignment>& assumptions, const Formula& formula) const {
  const auto& worlds = matching(assumptions);
  return std::any_of(worlds.begin(), worlds.end(), [&](const World* world) { return holds(formula, *world); });
}

bool Models::entails(const std::vector<Assignment>& assumptions, const Formula& formula, const Clocks& clocks) const {
  const auto& worlds = matching(assumptions);
  return std::all_of(worlds.begin(), worlds.end(), [&](const World* world) { return holds(formula, *world, clocks); });
}

std::vector<Assignment> assumptions_of(const automata::Plant& plant, const automata::Modes& modes) {
  std::vector<Assignment> result;
  for (std::size_t i = 0; i < modes.size(); ++i)
    result.push_back({plant.components[i].mode, automata::ValueId(modes[i].index())});
  return result;
}

std::vector<Assignment> assumptions_of(const automata::Plant& plant, const automata::ControlAction& action) {
  std::vector<Assignment> result;
  for (std::size_t i = 0; i < action.size(); ++i) result.push_back({plant.controls[i].variable, action[i]});
  return result;
}

std::vector<Assignment> assumptions_of(const automata::Plant& plant, const automata::Modes& modes,
                                       const automata::ControlAction& action) {
  std::vector<Assignment> result = assumptions_of(plant, modes);
  for (Assignment a : assumptions_of(plant, action)) result.push_back(a);
  return result;
}

}  // namespace rmpl::reference
