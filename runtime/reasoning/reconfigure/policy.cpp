// Policies by relaxation towards each target; components have few modes.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/policy.hpp"

#include <algorithm>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ModeId;

Policy::Policy(const std::vector<NominalTransition>& transitions, std::size_t modes, const std::vector<bool>& named)
    : modes_(modes), cells_(modes * modes) {
  for (std::size_t target = 0; target < modes; ++target) {
    Cell* const row = &cells_[target * modes];
    row[target].distance = Distance{};
    const auto through = [&](const NominalTransition& t) -> std::optional<Distance> {
      const auto& rest = row[t.to.index()].distance;
      if (!rest || t.from == t.to || !t.possible || !NominalGraph::permitted(t, named)) return std::nullopt;
      return *rest + Distance{t.reversible ? 0u : 1u, 1u};
    };
    for (bool shorter = true; shorter;) {
      shorter = false;
      for (const NominalTransition& t : transitions) {
        const auto distance = through(t);
        auto& known = row[t.from.index()].distance;
        if (!distance || (known && *known <= *distance)) continue;
        known = distance;
        shorter = true;
      }
    }
    for (const NominalTransition& t : transitions) {
      Cell& at = row[t.from.index()];
      if (t.from.index() != target && at.next == nullptr && at.distance && through(t) == at.distance) at.next = &t;
    }
  }
}

Policies::Policies(const automata::Plant& plant, const NominalGraph& graph)
    : graph_(graph), policies_(plant.components.size()) {
  NamedModes none;
  for (const auto& component : plant.components) none.emplace_back(component.modes.size());
  for (std::size_t c = 0; c < plant.components.size(); ++c) of(ComponentId(c), none);
}

const Policy& Policies::of(ComponentId component, const NamedModes& named) {
  const std::vector<bool>& modes = named[component.index()];
  auto& known = policies_[component.index()];
  const auto at = known.find(modes);
  if (at != known.end()) return at->second;
  return known.emplace(modes, Policy(graph_.transitions(component), modes.size(), modes)).first->second;
}

PolicyTable policy_table(const automata::Plant& plant, ComponentId component) {
  return policy_table(plant, NominalGraph(plant, Islands(plant)), component);
}

PolicyTable policy_table(const automata::Plant& plant, const NominalGraph& graph, ComponentId component) {
  const std::size_t modes = plant[component].modes.size();
  const Policy policy(graph.transitions(component), modes, std::vector<bool>(modes, true));

  PolicyTable table;
  for (std::size_t current = 0; current < modes; ++current) {
    auto& row = table.entries.emplace_back(modes);
    for (std::size_t target = 0; target < modes; ++target) {
      PolicyEntry& entry = row[target];
      const NominalTransition* const next = policy.next(ModeId(current), ModeId(target));
      if (current == target) {
        entry.kind = PolicyEntry::Kind::arrived;
      } else if (next != nullptr) {
        const bool uncommanded = std::any_of(next->supports.begin(), next->supports.end(),
                                             [&](const Support& s) { return needs_no_command(plant, s); });
        entry.kind = uncommanded ? PolicyEntry::Kind::wait : PolicyEntry::Kind::command;
        entry.transition = next->id;
        entry.irreversible = !next->reversible;
        entry.supports = next->supports;
      }
    }
  }
  return table;
}

}  // namespace rmpl::runtime
