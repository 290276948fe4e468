// What each component can come to: closures over its nominal transitions.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/prospects.hpp"

#include <algorithm>
#include <numeric>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ModeId;
using automata::Modes;

Prospects::Prospects(const NominalGraph& graph, const Modes& modes, const Goal& goal, bool keeping)
    : graph_(graph),
      modes_(modes),
      goal_(goal),
      drift_(drift_from(graph, modes)),
      passed_(only(graph, modes)),
      steps_(modes.size()),
      commandable_(modes.size()) {
  spread(graph, passed_, graph.components(), [&](ComponentId c, const NominalTransition& t) {
    if (!supported(t)) return false;
    if (drifts(graph, c, t, drift_)) return true;
    const bool leave = NominalGraph::harmless(t) || graph_.leads_to_named(c, t.to, goal_.named());
    return leave && (!keeping || goal_.permits(c, t.to));
  });
  for (std::size_t c = 0; c < modes.size(); ++c) count_steps(ComponentId(c));
  find_commandable();
}

bool Prospects::supported(const NominalTransition& t) const {
  return std::any_of(t.preconditions.begin(), t.preconditions.end(),
                     [&](const Precondition& s) { return runtime::supported(graph_, s, passed_); });
}

void Prospects::count_steps(ComponentId c) {
  const auto& names = goal_.named()[c.index()];
  auto& steps = steps_[c.index()];
  steps.assign(names.size(), std::nullopt);
  steps[modes_[c.index()].index()] = 0;
  for (bool fewer = true; fewer;) {
    fewer = false;
    for (const NominalTransition& t : graph_.transitions(c)) {
      const auto& before = steps[t.from.index()];
      auto& after = steps[t.to.index()];
      if (!before || !passed_[c.index()][t.to.index()] || !supported(t)) continue;
      const std::uint32_t count = *before + (NominalGraph::harmless(t) || drifts(graph_, c, t, drift_) ? 0 : 1);
      if (after && *after <= count) continue;
      after = count;
      fewer = true;
    }
  }
  for (std::size_t m = 0; m < names.size(); ++m) {
    if (steps[m] && *steps[m] > 0 && !names[m]) steps[m] = std::nullopt;
  }
}

/// Whether commands, or components that are commanded, decide whether the transition is taken: some precondition in
/// reach asks for them, and none is met whatever they do.
bool Prospects::felt(ComponentId c, const NominalTransition& t) const {
  if (t.commanded) return supported(t);
  bool felt = false;
  for (const Precondition& precondition : t.preconditions) {
    bool asks = false;
    bool met = true;
    for (const Requirement& r : precondition) {
      const auto other = graph_.component_of(r);
      if (other == c) continue;
      const bool now = other && std::binary_search(r.values.begin(), r.values.end(),
                                                   automata::ValueId(modes_[other->index()].index()));
      if (!other) {
        asks = true;
      } else if (commandable_[other->index()]) {
        const auto& reached = passed_[other->index()];
        for (std::size_t m = 0; m < reached.size(); ++m) {
          asks =
              asks || (reached[m] && now != std::binary_search(r.values.begin(), r.values.end(), automata::ValueId(m)));
        }
      }
      met = met && now;
    }
    if (!asks && met) return false;
    felt = felt || (asks && runtime::supported(graph_, precondition, passed_));
  }
  return felt;
}

/// Others are looked at again where one that they depend on turned out to be commandable.
void Prospects::find_commandable() {
  std::vector<std::size_t> queue(modes_.size());
  std::iota(queue.begin(), queue.end(), std::size_t{0});
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::size_t c = queue[next];
    if (commandable_[c]) continue;
    const auto& transitions = graph_.transitions(ComponentId(c));
    commandable_[c] = std::any_of(transitions.begin(), transitions.end(), [&](const NominalTransition& t) {
      return t.from == modes_[c] && t.to != t.from && passed_[c][t.to.index()] && felt(ComponentId(c), t);
    });
    if (!commandable_[c]) continue;
    for (const ComponentId dependent : graph_.dependents(ComponentId(c))) queue.push_back(dependent.index());
  }
}

Permitted Prospects::permitted(const Modes& target) const {
  Permitted permitted{Permitted::Steps(modes_.size()), Permitted::Steps(modes_.size())};
  for (std::size_t c = 0; c < modes_.size(); ++c) {
    const ComponentId id(c);
    const bool named = goal_.named()[c][target[c].index()];
    for (const NominalTransition& t : graph_.transitions(id)) {
      const bool granted = NominalGraph::harmless(t) || (named && graph_.leads_to_named(id, t.to, goal_.named()));
      permitted.granted[c].push_back(granted);
      permitted.on_ways[c].push_back(granted || drifts(graph_, id, t, drift_));
    }
  }
  return permitted;
}

std::pair<std::uint64_t, std::size_t> Prospects::effort(const Modes& modes, const Modes& target) const {
  std::pair<std::uint64_t, std::size_t> sum{0, 0};
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const ComponentId id(c);
    sum.first += *steps(id, target[c]);
    sum.second += modes[c] != target[c] && !commandable(id) ? 1 : 0;
  }
  return sum;
}

Prospects::Barrier Prospects::barrier(ComponentId component, const std::vector<bool>& wanted) const {
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
