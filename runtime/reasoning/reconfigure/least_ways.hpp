// Of one component, the least ways from every mode to one of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "runtime/reasoning/reconfigure/nominal_graph.hpp"

namespace rmpl::runtime {

/// What leads from a mode to the target: nothing where no way does.
template <class Cost>
struct LeastWay {
  std::optional<Cost> cost;
  const NominalTransition* next = nullptr;  ///< the transition that it begins with; null in the target itself
};

/// By mode. Costs add up, `cost_of` tells that of a transition, nothing where it may not be taken; no transition is for
/// nothing. Relaxed towards the target, as components have few modes.
template <class Cost, class CostOf>
std::vector<LeastWay<Cost>> least_ways(const std::vector<NominalTransition>& transitions, std::size_t modes,
                                       automata::ModeId target, const CostOf& cost_of) {
  std::vector<LeastWay<Cost>> ways(modes);
  ways[target.index()].cost = Cost{};
  for (bool less = true; less;) {
    less = false;
    for (const NominalTransition& t : transitions) {
      const LeastWay<Cost>& rest = ways[t.to.index()];
      const std::optional<Cost> own = rest.cost ? cost_of(t) : std::nullopt;
      if (!own) continue;
      const Cost all = *own + *rest.cost;
      LeastWay<Cost>& here = ways[t.from.index()];
      if (here.cost && *here.cost <= all) continue;
      here = {all, &t};
      less = true;
    }
  }
  return ways;
}

}  // namespace rmpl::runtime
