// The reactive planner: the transitions by which a component goes to a mode.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "runtime/reasoning/reconfigure/least_ways.hpp"
#include "runtime/reasoning/reconfigure/planner.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ModeId;
using automata::Modes;

std::optional<Planner::Effort> Planner::effort(const Modes& modes, const Objective& objective, ComponentId component,
                                               const NominalTransition& t) {
  std::optional<Effort> least;
  for (const Way& way : ways_.of(component, t)) {
    const auto others = detour(modes, objective, way);
    if (!others) continue;
    const Effort effort{others->and_back + Distance{NominalGraph::harmless(t) ? 0u : 1u, 1u},
                        pending(modes, way).size()};
    if (!least || effort < *least) least = effort;
  }
  return least;
}

Planner::Route Planner::route(const Modes& modes, const Objective& objective, ComponentId component, ModeId target) {
  const Policy& policy = policies_.of(component, objective.permitted);
  const ModeId current = modes[component.index()];
  Route shortest;
  for (const auto* t = policy.next(current, target); t != nullptr; t = policy.next(t->to, target)) {
    shortest.push_back(t);
  }
  const auto goes_alone = [&](const NominalTransition* step) {
    const auto& all = graph_.transitions(component);
    return std::any_of(all.begin(), all.end(), [&](const NominalTransition& t) {
      const auto& ways = ways_.of(component, t);
      return is_parallel(component, t, *step, objective.permitted) &&
             std::any_of(ways.begin(), ways.end(), [&](const Way& way) { return pending(modes, way).empty(); });
    });
  };
  if (std::all_of(shortest.begin(), shortest.end(), goes_alone)) return shortest;

  const auto& transitions = graph_.transitions(component);
  std::vector<std::optional<Effort>> efforts;
  for (std::size_t i = 0; i < transitions.size(); ++i) {
    const NominalTransition& t = transitions[i];
    const bool usable = t.possible && t.from != t.to && objective.permitted.on_ways[component.index()][i];
    efforts.push_back(usable ? effort(modes, objective, component, t) : std::nullopt);
  }
  const auto effort_of = [&](const NominalTransition& t) { return efforts[graph_.position(component, t)]; };
  const auto effort_of_shortest = [&]() -> std::optional<Effort> {
    Effort sum;
    for (const NominalTransition* const step : shortest) {
      std::optional<Effort> least;
      for (const NominalTransition& t : transitions) {
        if (!is_parallel(component, t, *step, objective.permitted) || !effort_of(t)) continue;
        if (!least || *effort_of(t) < *least) least = effort_of(t);
      }
      if (!least) return std::nullopt;
      sum = sum + *least;
    }
    return sum;
  };
  const auto ways = least_ways<Effort>(transitions, graph_.mode_count(component), target, effort_of);
  const auto& least = ways[current.index()].cost;
  const auto of_shortest = effort_of_shortest();
  if (!least || (of_shortest && *of_shortest <= *least)) return shortest;
  Route other;
  for (ModeId at = current; at != target; at = other.back()->to) other.push_back(ways[at.index()].next);
  return other;
}

bool Planner::is_under_way(const Modes& modes, const Objective& objective, ComponentId component) {
  const Route way = route(modes, objective, component, objective.target[component.index()]);
  return !way.empty() && way.front()->timed;
}

}  // namespace rmpl::runtime
