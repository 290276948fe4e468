// The goal interpreter, by conflict-directed best-first search.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/goal_interpreter.hpp"

#include <algorithm>
#include <limits>

#include "automata/assignment_text.hpp"

namespace rmpl::runtime {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::Theory;
using automata::ValueId;
using automata::VariableId;

namespace {

/// After the store was found to permit a world of the candidate in which the goal fails: that world is one of every
/// state whose components all have modes that it satisfies. So only those components are to blame that could be in a
/// mode that it does not satisfy.
std::vector<ComponentId> refuted_by_world(const Plant& plant, const Theory& theory,
                                          const std::vector<std::vector<bool>>& possible) {
  const auto value = [&](VariableId v) { return theory.value(v); };
  std::vector<ComponentId> blamed;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const Component& component = plant.components[c];
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      if (!possible[c][m] || evaluate(component.modes[m].constraint, value)) continue;
      blamed.emplace_back(c);
      break;
    }
  }
  return blamed;
}

Modes modes_of(std::span<const std::uint32_t> values) {
  Modes modes;
  for (const std::uint32_t m : values) modes.emplace_back(m);
  return modes;
}

}  // namespace

GoalInterpreter::GoalInterpreter(automata::PlantStep& step, const NominalGraph& graph) : step_(step), graph_(graph) {
  const auto& told = step.store().dependencies().constraints();
  store_reads_modes_ =
      std::any_of(told.begin(), told.end(), [this](const auto& reading) { return reads_modes(reading.variables); });
}

bool GoalInterpreter::reads_modes(const std::vector<VariableId>& variables) const {
  const automata::PlantIndex& index = step_.store().dependencies().index();
  return std::any_of(variables.begin(), variables.end(),
                     [&](VariableId v) { return index.component_of(v).has_value(); });
}

bool GoalInterpreter::is_local(const Goal& goal) const {
  return goal.rest() && !store_reads_modes_ && !reads_modes(variables_of(goal.rest()->formula));
}

bool GoalInterpreter::entailed(const Modes& modes, const Goal& goal) {
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (!goal.permits(ComponentId(c), modes[c])) return false;
  }
  return !goal.rest() || step_.theory().entails(assignments_of(step_.plant(), modes), goal.rest()->holds);
}

OptimalSearch::Costs GoalInterpreter::costs(const Modes& modes, const Goal& goal, const ReachableModes& reach,
                                            const Possible& possible) const {
  // Each count outweighs all that come after it.
  double modes_told = 1;
  for (const auto& own : possible) modes_told += static_cast<double>(own.size());
  const double leaving = modes_told, moved = leaving * static_cast<double>(modes.size() + 1);
  const double irreversible = moved * static_cast<double>(modes.size() + 1);
  OptimalSearch::Costs costs(modes.size());
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const ComponentId id(c);
    const auto& transitions = graph_.transitions(id);
    const auto& component = step_.plant()[id];
    for (std::size_t m = 0; m < possible[c].size(); ++m) {
      const ModeId mode(m);
      double& cost = costs[c].emplace_back(std::numeric_limits<double>::infinity());
      if (!possible[c][m]) continue;
      const auto leaves = [&](const NominalTransition& t) {
        return t.from == mode && t.to != t.from && t.comes_by_itself && t.possible;
      };
      const auto better =
          std::count_if(component.modes.begin(), component.modes.end(),
                        [&](const automata::Mode& other) { return other.reward > component.modes[m].reward; });
      cost = static_cast<double>(better);
      if (mode == modes[c]) continue;
      cost += moved;
      if (reach.is_irreversible(id, mode)) cost += irreversible;
      if (!goal.named()[c][m] && std::any_of(transitions.begin(), transitions.end(), leaves)) cost += leaving;
    }
  }
  return costs;
}

/// Why the state with these modes, which is possible, does not imply the goal: components to blame. The rest of a goal
/// is refuted in two ways: it cannot hold with some of the modes, or need not hold.
std::optional<std::vector<ComponentId>> GoalInterpreter::refuted(const Modes& candidate, const Goal& goal, bool local,
                                                                 const Possible& possible) {
  const auto& rest = goal.rest();
  if (!rest) return std::nullopt;
  Theory& theory = step_.theory();
  const auto assignments = assignments_of(step_.plant(), candidate);
  std::vector<ComponentId> blamed;
  if (theory.allows(assignments, rest->holds)) {
    if (!theory.allows(assignments, rest->fails)) return std::nullopt;
    if (local) return refuted_by_world(step_.plant(), theory, possible);
    for (std::size_t c = 0; c < candidate.size(); ++c) blamed.emplace_back(c);
    return blamed;
  }
  for (const Assignment& a : theory.conflict()) blamed.push_back(*step_.plant().component_of(a.variable));
  return blamed;
}

std::variant<Modes, Impasse> GoalInterpreter::interpret(const Modes& modes, const Goal& goal,
                                                        const ReachableModes& reach) {
  Possible possible(modes.size());
  for (std::size_t c = 0; c < modes.size(); ++c) {
    for (std::size_t m = 0; m < goal.named()[c].size(); ++m) {
      possible[c].push_back(reach.contains(ComponentId(c), ModeId(m)) && goal.permits(ComponentId(c), ModeId(m)));
    }
  }
  const bool local = is_local(goal);
  OptimalSearch search(costs(modes, goal, reach, possible));
  const auto outcome = search.next([&](std::span<const std::uint32_t> values) -> std::optional<Conflict> {
    const Modes candidate = modes_of(values);
    auto blamed = step_.possible(candidate) ? refuted(candidate, goal, local, possible)
                                            : std::optional(step_.refutation(candidate, {}).components);
    if (!blamed) return std::nullopt;
    Conflict conflict;
    for (const ComponentId c : *blamed) conflict.push_back({c.value, values[c.index()]});
    std::sort(conflict.begin(), conflict.end());
    return conflict;
  });
  if (outcome == OptimalSearch::Outcome::solution) return modes_of(search.values());
  return impasse(modes, goal, reach);
}

}  // namespace rmpl::runtime
