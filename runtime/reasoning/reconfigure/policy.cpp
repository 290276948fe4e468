// Policies by relaxation towards each target; components have few modes.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/policy.hpp"

#include <algorithm>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ModeId;

Policy::Policy(const std::vector<NominalTransition>& transitions, std::size_t modes, const std::vector<bool>& permitted)
    : modes_(modes), cells_(modes * modes) {
  for (std::size_t target = 0; target < modes; ++target) {
    Cell* const row = &cells_[target * modes];
    const auto cost_of = [&](const NominalTransition& t) -> std::optional<Distance> {
      if (t.from == t.to || !t.possible || !permitted[static_cast<std::size_t>(&t - transitions.data())])
        return std::nullopt;
      return Distance{NominalGraph::harmless(t) ? 0u : 1u, 1u};
    };
    row[target].distance = Distance{};
    for (bool less = true; less;) {
      less = false;
      for (const NominalTransition& t : transitions) {
        const auto& rest = row[t.to.index()].distance;
        const auto own = rest ? cost_of(t) : std::nullopt;
        auto& here = row[t.from.index()].distance;
        if (!own || (here && *here <= *own + *rest)) continue;
        here = *own + *rest;
        less = true;
      }
    }
    const auto through = [&](const NominalTransition& t) -> std::optional<Distance> {
      const auto& rest = row[t.to.index()].distance;
      const auto own = cost_of(t);
      return rest && own ? std::optional(*rest + *own) : std::nullopt;
    };
    for (const NominalTransition& t : transitions) {
      Cell& at = row[t.from.index()];
      if (t.from.index() == target || !at.distance || through(t) != at.distance) continue;
      const bool sooner = at.next != nullptr && at.next->to == t.to && at.next->timed && !t.timed;
      if (at.next == nullptr || sooner) at.next = &t;
    }
  }
}

PolicyTable policy_table(const automata::Plant& plant, ComponentId component) {
  return policy_table(plant, NominalGraph(plant), component);
}

PolicyTable policy_table(const automata::Plant& plant, const NominalGraph& graph, ComponentId component) {
  const std::size_t modes = plant[component].modes.size();
  const auto& transitions = graph.transitions(component);
  const Policy policy(transitions, modes, std::vector<bool>(transitions.size(), true));

  PolicyTable table;
  for (std::size_t current = 0; current < modes; ++current) {
    auto& row = table.entries.emplace_back(modes);
    for (std::size_t target = 0; target < modes; ++target) {
      PolicyEntry& entry = row[target];
      const NominalTransition* const next = policy.next(ModeId(current), ModeId(target));
      if (current == target) {
        entry.kind = PolicyEntry::Kind::arrived;
      } else if (next != nullptr) {
        const bool uncommanded = std::find(next->silent.begin(), next->silent.end(), true) != next->silent.end();
        entry.kind = uncommanded ? PolicyEntry::Kind::wait : PolicyEntry::Kind::command;
        entry.transition = next->id;
        entry.irreversible = !NominalGraph::harmless(*next);
        for (std::size_t p = 0; p < next->preconditions.size(); ++p) {
          if (!uncommanded || next->silent[p]) entry.preconditions.push_back(next->preconditions[p]);
        }
      }
    }
  }
  return table;
}

}  // namespace rmpl::runtime
