// Goals one after the other, as many as have a plan.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/several_goals.hpp"

#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

namespace rmpl::runtime {

using automata::Goals;

std::vector<Goals> goals_of(const automata::Asserted& asserted) {
  std::vector<Goals> goals;
  if (!asserted.empty()) goals.push_back(asserted);
  goals.insert(goals.end(), asserted.branches.begin(), asserted.branches.end());
  return goals;
}

Pursued pursue(Reconfigurer& reconfigurer, std::span<const automata::Modes> tracked, std::span<const Goals> goals,
               const StrategyPosition& position) {
  Pursued all;
  if (!goals.empty()) all.goals = together(goals);
  all.answer = reconfigurer.next_of_all(tracked, all.goals.formula(), position);
  if (goals.size() < 2 || all.answer.outcome != Reconfiguration::Outcome::no_plan) return all;
  std::size_t checked = all.answer.checked;
  const auto ask = [&](const Goals& asked) {
    Reconfiguration answer = reconfigurer.next_of_all(tracked, asked.formula(), position);
    checked += answer.checked;
    return answer;
  };
  const auto planned = [](const Reconfiguration& answer) {
    return answer.outcome != Reconfiguration::Outcome::no_plan;
  };
  Pursued result;
  std::vector<Goals> kept;
  std::vector<std::pair<Goals, Reconfiguration>> refused;
  for (const Goals& goal : goals) {
    kept.push_back(goal);
    Goals tried = together(kept);
    Reconfiguration answer = ask(tried);
    if (planned(answer)) {
      result.goals = std::move(tried);
      result.answer = std::move(answer);
      continue;
    }
    kept.pop_back();
    // What bars the way is told of the goal by itself, where it bars that.
    Reconfiguration alone = kept.empty() ? answer : ask(goal);
    refused.emplace_back(goal, planned(alone) ? std::move(answer) : std::move(alone));
  }
  if (kept.empty()) {
    std::tie(result.goals, result.answer) = std::move(refused.front());
    refused.erase(refused.begin());
  }
  for (const auto& [goal, answer] : refused) {
    result.left_out.push_back({goal, answer.why, answer.component, answer.reason});
  }
  result.answer.checked = checked;
  return result;
}

bool speaks_of(const Goals& goals, automata::ComponentId component, const automata::Plant& plant) {
  const std::string& name = plant[component].name;
  for (const automata::VariableId variable : variables_of(goals.formula())) {
    const std::string_view spoken_of = plant.variables.name(variable);
    const bool own = spoken_of.starts_with(name) && (spoken_of.size() == name.size() || spoken_of[name.size()] == '.');
    if (own) return true;
  }
  return false;
}

bool no_plan(const Goals& pursued, Reconfiguration::Outcome outcome, const std::vector<LeftOut>& left_out,
             std::optional<automata::ComponentId> component, const automata::Plant& plant) {
  const auto counts = [&](const Goals& goals) { return !component || speaks_of(goals, *component, plant); };
  return (outcome == Reconfiguration::Outcome::no_plan && counts(pursued)) ||
         std::any_of(left_out.begin(), left_out.end(), [&](const LeftOut& other) { return counts(other.goals); });
}

}  // namespace rmpl::runtime
