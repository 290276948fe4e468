// Layer by layer, nothing left out.
// SPDX-License-Identifier: MIT
#include "tests/reference/marking_plans.hpp"

#include <algorithm>
#include <map>

namespace rmpl::reference {

std::optional<PlanCost> cheapest(const ModelProgramStep& step, const std::vector<FreeCommand>& free,
                                 const MarkedSet& from, const std::vector<automata::Assignment>& goal,
                                 std::size_t most) {
  const auto entails = [&](const MarkedSet& marking) {
    const auto values = step.values(marking);
    return std::all_of(goal.begin(), goal.end(), [&](const automata::Assignment& wanted) {
      const auto value = values.find(wanted.variable);
      return value != values.end() && value->second == wanted.value;
    });
  };
  std::map<MarkedSet, std::size_t> layer{{from, 0}};  // the fewest values off idle on a way there
  for (std::size_t steps = 0; steps <= most; ++steps) {
    std::optional<PlanCost> best;
    for (const auto& [marking, busy] : layer) {
      if (entails(marking)) best = std::min(best.value_or(PlanCost{steps, busy}), PlanCost{steps, busy});
    }
    if (best) return best;
    std::map<MarkedSet, std::size_t> next;
    for (const auto& reached : layer) {
      for (const FreeCommand& command : free) {
        step.for_each_next(reached.first, command.values, [&](const MarkedSet& target, double, unsigned improbable) {
          if (improbable > 0) return;
          const std::size_t busy = reached.second + command.busy;
          const auto known = next.try_emplace(target, busy).first;
          known->second = std::min(known->second, busy);
        });
      }
    }
    layer = std::move(next);
  }
  return std::nullopt;
}

}  // namespace rmpl::reference
