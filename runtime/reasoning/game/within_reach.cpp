// A closure over all steps but those that no strategy may take.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/within_reach.hpp"

namespace rmpl::runtime {

using automata::ComponentId;

WithinReach within_reach(const NominalGraph& graph, const GameGoal& goal, const automata::Modes& modes,
                         const std::vector<ComponentId>& free) {
  WithinReach result{only(graph, modes), {}};
  const auto needs_leave = [&](ComponentId c, const NominalTransition& t) {
    return t.irreversible && !goal.licenses(c, t.id);
  };
  std::vector<bool> moves(modes.size());
  for (const ComponentId c : free) moves[c.index()] = true;
  const auto comes = [&](ComponentId c, const NominalTransition& t) {
    if (!moves[c.index()]) return false;
    if (!t.all_preconditions) return true;
    return needs_leave(c, t) ? comes_by_itself(graph, c, t, result.modes) : supported(graph, t, result.modes);
  };
  spread(graph, result.modes, comes);
  result.barred.resize(modes.size());
  for (const ComponentId c : graph.components()) {
    for (const NominalTransition& t : graph.transitions(c))
      result.barred[c.index()].push_back(needs_leave(c, t) &&
                                         !(result.modes[c.index()][t.from.index()] && comes(c, t)));
  }
  return result;
}

}  // namespace rmpl::runtime
