// The goal interpreter, by conflict-directed best-first search.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/goal_interpreter.hpp"

#include <algorithm>
#include <limits>

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

/// A candidate's decisions, and how conflicts in terms of assignments become conflicts in terms of decisions.
class Candidate {
 public:
  Candidate(const Plant& plant, std::span<const std::uint32_t> values) : values_(values) {
    for (std::size_t c = 0; c < values.size(); ++c) {
      assignments_.push_back({plant.components[c].mode, ValueId(values[c])});
    }
  }
  [[nodiscard]] const std::vector<Assignment>& assignments() const { return assignments_; }
  [[nodiscard]] Conflict conflict(const std::vector<Assignment>& blamed) const {
    Conflict result;
    for (std::uint32_t c = 0; c < values_.size(); ++c) {
      if (std::find(blamed.begin(), blamed.end(), assignments_[c]) != blamed.end()) result.push_back({c, values_[c]});
    }
    return result;
  }
  /// After the store was found to permit a world of the candidate in which the goal fails: that world is one of every
  /// state whose components all have modes that it satisfies. So only those components are to blame that could be in a
  /// mode that it does not satisfy.
  [[nodiscard]] Conflict refuted_by_world(const Plant& plant, const Theory& theory,
                                          const std::vector<std::vector<bool>>& possible) const {
    const auto value = [&](VariableId v) { return theory.value(v); };
    Conflict result;
    for (std::uint32_t c = 0; c < values_.size(); ++c) {
      const Component& component = plant.components[c];
      for (std::size_t m = 0; m < component.modes.size(); ++m) {
        if (!possible[c][m] || evaluate(component.modes[m].constraint, value)) continue;
        result.push_back({c, values_[c]});
        break;
      }
    }
    return result;
  }

 private:
  std::span<const std::uint32_t> values_;
  std::vector<Assignment> assignments_;
};

/// Whether the argument of `refuted_by_world` holds: neither Q, nor a mode constraint, nor the goal reads a mode.
bool reads_modes(const Plant& plant, const automata::Formula& goal) {
  const auto reads = [&](const automata::Formula& formula) {
    const auto variables = variables_of(formula);
    return std::any_of(variables.begin(), variables.end(),
                       [&](VariableId v) { return plant.component_of(v).has_value(); });
  };
  return reads(goal) || std::any_of(plant.interconnections.begin(), plant.interconnections.end(), reads) ||
         std::any_of(plant.components.begin(), plant.components.end(), [&](const Component& c) {
           return std::any_of(c.modes.begin(), c.modes.end(), [&](const auto& m) { return reads(m.constraint); });
         });
}

}  // namespace

std::variant<Modes, Impasse> GoalInterpreter::interpret(const Modes& modes, const Goal& goal,
                                                        std::optional<Choice>& last) {
  const Plant& plant = step_.plant();
  Theory& theory = step_.theory();
  const Reachable reachable = graph_.reachable(modes, goal.named());
  Reachable possible = reachable;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    for (std::size_t m = 0; m < possible[c].size(); ++m) {
      possible[c][m] = possible[c][m] && goal.permits(ComponentId(c), ModeId(m));
    }
  }
  checked_ = 0;
  if (last && last->possible == possible) return last->state;
  OptimalSearch::Costs costs;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const Component& component = plant.components[c];
    const auto& may = possible[c];
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < may.size(); ++m) {
      if (may[m]) best = std::max(best, component.modes[m].reward);
    }
    auto& cost = costs.emplace_back();
    for (std::size_t m = 0; m < may.size(); ++m) {
      cost.push_back(may[m] ? best - component.modes[m].reward : std::numeric_limits<double>::infinity());
    }
  }

  // The rest of a goal is refuted in two ways: it cannot hold with some of the modes, or need not hold.
  const auto& rest = goal.rest();
  const bool local = rest && !reads_modes(plant, rest->formula);
  const auto check = [&](std::span<const std::uint32_t> values) -> std::optional<Conflict> {
    if (!rest) return refuted(values);
    const Candidate candidate(plant, values);
    const auto& assignments = candidate.assignments();
    if (!theory.allows(assignments, rest->holds)) return candidate.conflict(theory.conflict());
    if (!theory.allows(assignments, rest->fails)) return std::nullopt;
    return local ? candidate.refuted_by_world(plant, theory, possible) : candidate.conflict(assignments);
  };
  OptimalSearch search(costs);
  const auto outcome = search.next(check);
  checked_ = search.checked();
  switch (outcome) {
    case OptimalSearch::Outcome::solution: {
      Modes goal_state;
      for (const std::uint32_t m : search.values()) goal_state.emplace_back(m);
      last = Choice{std::move(possible), goal_state};
      return goal_state;
    }
    case OptimalSearch::Outcome::exhausted:
    case OptimalSearch::Outcome::budget:
      break;
  }
  return impasse(modes, goal, reachable);
}

/// Why no state has these modes, as a conflict.
std::optional<Conflict> GoalInterpreter::refuted(std::span<const std::uint32_t> values) {
  Modes modes;
  for (const std::uint32_t m : values) modes.emplace_back(m);
  if (step_.possible(modes)) return std::nullopt;
  Conflict conflict;
  for (const ComponentId c : step_.refutation(modes, {}).components) conflict.push_back({c.value, values[c.index()]});
  return conflict;
}

/// Goes upstream as long as it is another component that bars the way: the last one is to blame.
Impasse GoalInterpreter::out_of_reach(const Modes& modes, const Goal& goal, const Reachable& reachable,
                                      ComponentId component, std::vector<bool> asked) {
  const Plant& plant = step_.plant();
  const auto name = [&](ComponentId c, ModeId m) { return "'" + plant[c].modes[m.index()].name + "'"; };
  std::string purpose;
  std::vector<bool> visited(modes.size());
  for (;;) {
    std::string wanted;
    for (std::size_t m = 0; m < asked.size(); ++m) {
      if (asked[m]) wanted += (wanted.empty() ? "" : " or ") + name(component, ModeId(m));
    }
    if (wanted.empty()) return {component, "the goal permits no mode of '" + plant[component].name + "'"};
    const auto obstacle = graph_.obstacle(component, asked, reachable, goal.named());
    if (!obstacle || visited[component.index()]) {
      return {component, "no permitted nominal transitions lead '" + plant[component].name + "' from " +
                             name(component, modes[component.index()]) + " to " + wanted + purpose};
    }
    visited[component.index()] = true;
    purpose = ", as it takes for '" + plant[component].name + "' to go from " +
              name(component, obstacle->transition->from) + " to " + name(component, obstacle->transition->to) +
              purpose;
    component = *plant.component_of(obstacle->requirement->variable);
    asked.assign(plant[component].modes.size(), false);
    for (const ValueId v : obstacle->requirement->values) asked[v.index()] = true;
  }
}

/// The most telling of: a component that cannot reach what the goal asks of it; modes that are the only ones left and
/// exclude each other or the goal.
Impasse GoalInterpreter::impasse(const Modes& modes, const Goal& goal, const Reachable& reachable) {
  const Plant& plant = step_.plant();
  std::vector<Assignment> forced;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const Component& component = plant.components[c];
    std::vector<ModeId> left;
    std::vector<bool> asked(component.modes.size());
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      asked[m] = goal.permits(ComponentId(c), ModeId(m));
      if (asked[m] && reachable[c][m]) left.emplace_back(m);
    }
    if (left.empty()) return out_of_reach(modes, goal, reachable, ComponentId(c), std::move(asked));
    if (left.size() == 1) forced.push_back({component.mode, ValueId(left.front().index())});
  }
  const auto& rest = goal.rest();
  Theory& theory = step_.theory();
  const bool excluded = rest ? !theory.allows(forced, rest->holds) : !theory.consistent(forced);
  if (!excluded) return {std::nullopt, "no state that can be reached implies the goal"};

  if (theory.conflict().empty()) return {std::nullopt, "nothing that the plant can be in implies the goal"};

  // The one to blame is a component in a fault mode, where there is one: the others do what they are asked.
  Impasse result;
  for (const Assignment& a : theory.conflict()) {
    const ComponentId c = *plant.component_of(a.variable);
    if (!result.component || (plant[c].modes[a.value.index()].fault &&
                              !plant[*result.component].modes[modes[result.component->index()].index()].fault)) {
      result.component = c;
    }
    result.reason +=
        (result.reason.empty() ? "" : " & ") + plant.variables.name(a.variable) + " = " + plant.variables.value(a);
  }
  result.reason = "no state that can be reached implies the goal: " + result.reason +
                  (rest ? " exclude it" : " exclude each other, and are all that is left");
  return result;
}

}  // namespace rmpl::runtime
