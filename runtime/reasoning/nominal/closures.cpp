// Closures over the nominal transitions of all components.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/nominal/closures.hpp"

#include <algorithm>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Modes;

namespace {

/// Whether what is reached meets each requirement, one by one.
bool supported(const NominalGraph& graph, const Precondition& precondition, const Reached& reached) {
  return std::all_of(precondition.begin(), precondition.end(),
                     [&](const Requirement& r) { return graph.meets(r, reached); });
}

}  // namespace

bool supported(const NominalGraph& graph, const NominalTransition& t, const Reached& reached) {
  return std::any_of(t.preconditions.begin(), t.preconditions.end(),
                     [&](const Precondition& p) { return supported(graph, p, reached); });
}

bool comes_by_itself(const NominalGraph& graph, ComponentId c, const NominalTransition& t, const Reached& reached) {
  if (!t.possible || !reached[c.index()][t.from.index()]) return false;
  for (std::size_t i = 0; i < t.preconditions.size(); ++i) {
    if (t.silent[i] && supported(graph, t.preconditions[i], reached)) return true;
  }
  return false;
}

void spread(const NominalGraph& graph, Reached& reached,
            base::FunctionRef<bool(ComponentId, const NominalTransition&)> usable) {
  std::vector<ComponentId> queue = graph.components();
  std::vector<bool> queued(reached.size(), true);
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const ComponentId c = queue[next];
    std::vector<bool>& own = reached[c.index()];
    queued[c.index()] = false;
    bool further = false;
    for (bool grown = true; grown;) {
      grown = false;
      for (const NominalTransition& t : graph.transitions(c)) {
        if (!own[t.from.index()] || own[t.to.index()] || !t.possible || !usable(c, t)) continue;
        own[t.to.index()] = grown = further = true;
      }
    }
    if (!further) continue;
    for (const ComponentId dependent : graph.dependents(c)) {
      if (!queued[dependent.index()]) queue.push_back(dependent);
      queued[dependent.index()] = true;
    }
  }
}

Reached only(const NominalGraph& graph, const Modes& modes) {
  Reached reached(modes.size());
  for (const ComponentId c : graph.components()) {
    reached[c.index()].resize(graph.mode_count(c));
    reached[c.index()][modes[c.index()].index()] = true;
  }
  return reached;
}

void spread_at_rest(const NominalGraph& graph, Reached& reached) {
  spread(graph, reached,
         [&](ComponentId c, const NominalTransition& t) { return comes_by_itself(graph, c, t, reached); });
}

}  // namespace rmpl::runtime
