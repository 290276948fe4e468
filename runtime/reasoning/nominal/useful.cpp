// Useful steps, by a closure over what is wanted.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/nominal/useful.hpp"

#include <algorithm>
#include <set>

namespace rmpl::runtime {

using automata::ComponentId;

namespace {

/// Whether some path of steps leads from the target to a wanted mode, and not through the source.
/// Cost: the transitions of the component.
bool leads_on(const NominalGraph& graph, ComponentId c, const NominalTransition& step,
              const std::vector<bool>& wanted) {
  std::vector<bool> seen(wanted.size());
  seen[step.from.index()] = true;
  std::vector<automata::ModeId> open;
  const auto visit = [&](automata::ModeId mode) {
    if (!seen[mode.index()]) open.push_back(mode);
    seen[mode.index()] = true;
  };
  visit(step.to);
  while (!open.empty()) {
    const automata::ModeId mode = open.back();
    open.pop_back();
    if (wanted[mode.index()]) return true;
    for (const NominalTransition& t : graph.transitions(c)) {
      if (t.from == mode) visit(t.to);
    }
  }
  return false;
}

}  // namespace

UsefulSteps::UsefulSteps(const NominalGraph& graph, std::vector<WantedModes> wanted)
    : useful_(graph.components().size()) {
  std::set<WantedModes> known(wanted.begin(), wanted.end());
  while (!wanted.empty()) {
    const auto [c, modes] = std::move(wanted.back());
    wanted.pop_back();
    for (const NominalTransition& t : graph.transitions(c)) {
      if (modes[t.from.index()]) continue;
      auto& useful = useful_[c.index()];
      const auto at = std::lower_bound(useful.begin(), useful.end(), t.id);
      // Its preconditions are wanted already where it is known.
      if ((at != useful.end() && *at == t.id) || !leads_on(graph, c, t, modes)) continue;
      useful.insert(at, t.id);
      for (const Precondition& precondition : t.preconditions) {
        for (const Requirement& r : precondition) {
          const auto other = graph.component_of(r);
          if (!other) continue;
          WantedModes more{*other, std::vector<bool>(graph.mode_count(*other))};
          for (const automata::ValueId v : r.values) more.second[v.index()] = true;
          if (known.insert(more).second) wanted.push_back(std::move(more));
        }
      }
    }
  }
}

bool UsefulSteps::has(ComponentId component, automata::TransitionId transition) const {
  const auto& useful = useful_[component.index()];
  return std::binary_search(useful.begin(), useful.end(), transition);
}

}  // namespace rmpl::runtime
