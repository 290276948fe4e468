// The goal interpreter, by conflict-directed best-first search.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/goal_interpreter.hpp"

#include <algorithm>
#include <cmath>
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

GoalInterpreter::GoalInterpreter(automata::PlantStep& step, const NominalGraph& graph)
    : step_(step), graph_(graph), rewards_(whole_rewards(step.plant())) {
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

namespace {

/// What a candidate is judged by, least important last: one number where each count outweighs all that come after it.
struct Merits {
  double irreversible = 0, uncommandable = 0, leaving = 0, reward = 0, moved = 0;
};

/// Weights that keep the order of merits; 2^53 is as far as whole numbers are exact.
Merits weights_for(const Merits& greatest) {
  Merits weight;
  for (double unit = 1;; unit /= 10) {
    weight.moved = 1;
    weight.reward = greatest.moved + 1;
    weight.leaving = weight.reward * (std::ceil(greatest.reward * unit) + 1);
    weight.uncommandable = weight.leaving * (greatest.leaving + 1);
    weight.irreversible = weight.uncommandable * (greatest.uncommandable + 1);
    if (weight.irreversible * (greatest.irreversible + 1) <= std::ldexp(1.0, 53) || unit < 1e-18) return weight;
  }
}

}  // namespace

OptimalSearch::Costs GoalInterpreter::costs(const Modes& modes, const Goal& goal, const Prospects& prospects,
                                            const Possible& possible) const {
  std::vector<std::vector<Merits>> merits(modes.size());
  Merits greatest;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const ComponentId id(c);
    std::int64_t best = std::numeric_limits<std::int64_t>::min();
    for (std::size_t m = 0; m < possible[c].size(); ++m) {
      if (possible[c][m]) best = std::max(best, rewards_[c][m]);
    }
    const auto& transitions = graph_.transitions(id);
    Merits most;
    for (std::size_t m = 0; m < possible[c].size(); ++m) {
      Merits& at = merits[c].emplace_back();
      if (!possible[c][m]) continue;
      const bool moved = modes[c] != ModeId(m);
      const auto leaves = [&](const NominalTransition& t) {
        return t.from == ModeId(m) && t.to != t.from && t.comes_by_itself && t.possible;
      };
      const bool unasked = moved && !goal.named()[c][m];
      at.irreversible = *prospects.steps(id, ModeId(m));
      at.uncommandable = moved && !prospects.commandable(id) ? 1 : 0;
      at.leaving = unasked && std::any_of(transitions.begin(), transitions.end(), leaves) ? 1 : 0;
      at.reward = static_cast<double>(best - rewards_[c][m]);
      at.moved = moved ? 1 : 0;
      most = {std::max(most.irreversible, at.irreversible), std::max(most.uncommandable, at.uncommandable),
              std::max(most.leaving, at.leaving), std::max(most.reward, at.reward), std::max(most.moved, at.moved)};
    }
    greatest = {greatest.irreversible + most.irreversible, greatest.uncommandable + most.uncommandable,
                greatest.leaving + most.leaving, greatest.reward + most.reward, greatest.moved + most.moved};
  }
  const Merits weight = weights_for(greatest);
  const double coarse = greatest.reward > 0 ? (weight.leaving / weight.reward - 1) / greatest.reward : 1;
  const double unit = coarse < 1 ? coarse : 1;
  OptimalSearch::Costs costs(modes.size());
  for (std::size_t c = 0; c < modes.size(); ++c) {
    for (std::size_t m = 0; m < possible[c].size(); ++m) {
      const Merits& at = merits[c][m];
      costs[c].push_back(possible[c][m]
                             ? at.irreversible * weight.irreversible + at.uncommandable * weight.uncommandable +
                                   at.leaving * weight.leaving + std::floor(at.reward * unit) * weight.reward + at.moved
                             : std::numeric_limits<double>::infinity());
    }
  }
  return costs;
}

/// Why no state has these modes, or why it does not imply the goal: components to blame. The rest of a goal is refuted
/// in two ways: it cannot hold with some of the modes, or need not hold.
std::optional<std::vector<ComponentId>> GoalInterpreter::refuted(const Modes& candidate, const Goal& goal, bool local,
                                                                 const Possible& possible) {
  const auto& rest = goal.rest();
  if (!rest) {
    if (step_.possible(candidate)) return std::nullopt;
    return step_.refutation(candidate, {}).components;
  }
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
                                                        const Prospects& prospects, const HasPlan& has_plan) {
  Possible possible(modes.size());
  for (std::size_t c = 0; c < modes.size(); ++c) {
    for (std::size_t m = 0; m < goal.named()[c].size(); ++m) {
      possible[c].push_back(prospects.steps(ComponentId(c), ModeId(m)).has_value() &&
                            goal.permits(ComponentId(c), ModeId(m)));
    }
  }
  const bool local = is_local(goal);
  auto known = std::make_shared<ConflictSet>();
  for (const Conflict& conflict : excluded_) known->add(conflict);
  OptimalSearch search(costs(modes, goal, prospects, possible), std::move(known));
  const auto outcome = search.next([&](std::span<const std::uint32_t> values) -> std::optional<Conflict> {
    const Modes candidate = modes_of(values);
    const bool exists = step_.possible(candidate);
    auto blamed =
        exists ? refuted(candidate, goal, local, possible) : std::optional(step_.refutation(candidate, {}).components);
    if (!blamed) blamed = has_plan(candidate);
    if (!blamed) return std::nullopt;
    Conflict conflict;
    for (const ComponentId c : *blamed) conflict.push_back({c.value, values[c.index()]});
    std::sort(conflict.begin(), conflict.end());
    if (!exists && excluded_.size() < excluded_limit) excluded_.push_back(conflict);
    return conflict;
  });
  checked_ = search.checked();
  if (outcome == OptimalSearch::Outcome::solution) return modes_of(search.values());
  return impasse(modes, goal, prospects);
}

std::vector<ComponentId> GoalInterpreter::needed(const Modes& modes, const Modes& target, const Goal& goal) {
  // What must change is often enough: then nothing smaller is.
  std::vector<ComponentId> must_change;
  Modes least = modes;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (goal.permits(ComponentId(c), modes[c])) continue;
    must_change.emplace_back(c);
    least[c] = target[c];
  }
  if (!goal.rest() && step_.possible(least)) return must_change;
  constexpr double never = std::numeric_limits<double>::infinity();
  Possible possible(modes.size());
  OptimalSearch::Costs costs;  // first to change, then to stay: of equal sets the first declared
  for (std::size_t c = 0; c < modes.size(); ++c) {
    possible[c].assign(goal.named()[c].size(), false);
    const bool same = modes[c] == target[c];
    const bool must = !goal.permits(ComponentId(c), modes[c]);
    possible[c][target[c].index()] = true;
    if (!must) possible[c][modes[c].index()] = true;
    costs.push_back({same ? never : 1.0, must ? never : 0.0});
  }
  const bool local = is_local(goal);
  Modes candidate = modes;
  OptimalSearch search(costs);
  const auto outcome = search.next([&](std::span<const std::uint32_t> values) -> std::optional<Conflict> {
    for (std::size_t c = 0; c < modes.size(); ++c) candidate[c] = values[c] == 0 ? target[c] : modes[c];
    const auto blamed = refuted(candidate, goal, local, possible);
    if (!blamed) return std::nullopt;
    Conflict conflict;
    for (const ComponentId c : *blamed) conflict.push_back({c.value, values[c.index()]});
    std::sort(conflict.begin(), conflict.end());
    return conflict;
  });
  std::vector<ComponentId> result;
  for (std::size_t c = 0; c < modes.size() && outcome == OptimalSearch::Outcome::solution; ++c) {
    if (candidate[c] != modes[c]) result.emplace_back(c);
  }
  return result;
}

}  // namespace rmpl::runtime
