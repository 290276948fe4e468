// What each component can come to, with the leave of the goal.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/reachable_modes.hpp"

#include <algorithm>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ModeId;
using automata::Modes;

ReachableModes::ReachableModes(const NominalGraph& graph, const Modes& modes, const Goal& goal)
    : graph_(graph), goal_(goal), passed_(only(graph, modes)), freely_(only(graph, modes)) {
  Reached at_rest = only(graph, modes);
  spread_at_rest(graph, at_rest);
  const auto free = [&](ComponentId c, const NominalTransition& t) {
    return NominalGraph::harmless(t) || comes_by_itself(graph, c, t, at_rest);
  };
  spread(graph, passed_, [&](ComponentId c, const NominalTransition& t) {
    return supported(graph, t, passed_) && (free(c, t) || graph.leads_to_named(c, t.to, goal.named()));
  });
  spread(graph, freely_,
         [&](ComponentId c, const NominalTransition& t) { return supported(graph, t, passed_) && free(c, t); });
}

ReachableModes::Barrier ReachableModes::barrier(ComponentId component, const std::vector<bool>& wanted) const {
  const auto& own = passed_[component.index()];
  Barrier first;
  for (const NominalTransition& t : graph_.transitions(component)) {
    if (!own[t.from.index()] || own[t.to.index()] || !t.possible) continue;
    bool leads = false;
    for (std::size_t m = 0; m < wanted.size(); ++m)
      leads = leads || (wanted[m] && graph_.leads(component, t.to, ModeId(m)));
    if (!leads || (first.transition != nullptr && !wanted[t.to.index()])) continue;
    const Precondition& precondition = t.preconditions.front();
    const auto unmet = std::find_if(precondition.begin(), precondition.end(),
                                    [&](const Requirement& r) { return !graph_.meets(r, passed_); });
    const bool leave = NominalGraph::harmless(t) || graph_.leads_to_named(component, t.to, goal_.named());
    if (leave && unmet == precondition.end()) continue;
    first = {&t, leave ? &*unmet : nullptr};
    if (wanted[t.to.index()]) break;
  }
  return first;
}

}  // namespace rmpl::runtime
