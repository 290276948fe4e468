// Closures over nominal transitions.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/drift.hpp"

#include <algorithm>
#include <limits>

namespace rmpl::runtime {

using automata::ComponentId;

bool supported(const NominalGraph& graph, const Precondition& precondition, const Reached& reached) {
  return std::all_of(precondition.begin(), precondition.end(),
                     [&](const Requirement& r) { return graph.meets(r, reached); });
}

void spread(const NominalGraph& graph, Reached& reached, const std::vector<ComponentId>& components,
            base::FunctionRef<bool(ComponentId, const NominalTransition&)> usable) {
  std::vector<ComponentId> queue = components;
  std::vector<bool> queued(reached.size());
  for (const ComponentId c : queue) queued[c.index()] = true;
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
      if (queued[dependent.index()] || reached[dependent.index()].empty()) continue;
      queued[dependent.index()] = true;
      queue.push_back(dependent);
    }
  }
}

bool comes_by_itself(const NominalGraph& graph, const NominalTransition& t, const Reached& reached) {
  for (std::size_t i = 0; i < t.preconditions.size(); ++i) {
    if (t.silent[i] && supported(graph, t.preconditions[i], reached)) return true;
  }
  return false;
}

void drift(const NominalGraph& graph, Reached& reached, const std::vector<ComponentId>& components, Drift how) {
  spread(graph, reached, components, [&](ComponentId, const NominalTransition& t) {
    return !(t.timed && how == Drift::untimed) && comes_by_itself(graph, t, reached);
  });
}

bool drifts(const NominalGraph& graph, ComponentId component, const NominalTransition& t, const Reached& reached) {
  return t.possible && reached[component.index()][t.from.index()] && comes_by_itself(graph, t, reached);
}

Reached only(const NominalGraph& graph, const automata::Modes& modes) {
  Reached reached(modes.size());
  for (const ComponentId c : graph.components()) {
    reached[c.index()].resize(graph.mode_count(c));
    reached[c.index()][modes[c.index()].index()] = true;
  }
  return reached;
}

Reached drift_from(const NominalGraph& graph, const automata::Modes& modes, Drift how) {
  Reached reached = only(graph, modes);
  drift(graph, reached, graph.components(), how);
  return reached;
}

std::int64_t lasting_reward(const WholeRewards& rewards, const Reached& reached,
                            const std::vector<ComponentId>& components) {
  std::int64_t sum = 0;
  for (const ComponentId c : components) {
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (std::size_t m = 0; m < reached[c.index()].size(); ++m) {
      if (reached[c.index()][m]) least = std::min(least, rewards[c.index()][m]);
    }
    sum += least;
  }
  return sum;
}

}  // namespace rmpl::runtime
