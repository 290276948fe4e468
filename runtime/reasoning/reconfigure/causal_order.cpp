// The causal order: what is upstream of what, transitively, then the components by turns.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/causal_order.hpp"

#include <algorithm>
#include <optional>
#include <queue>
#include <unordered_map>

#include "base/strong_components.hpp"

namespace rmpl::runtime {

using automata::ComponentId;

namespace {

using Upstream = std::vector<std::vector<std::size_t>>;

base::StrongComponents cycles_of(const Upstream& upstream) {
  return base::strong_components(upstream.size(), [&](std::size_t c, std::size_t i) {
    return i < upstream[c].size() ? std::optional(upstream[c][i]) : std::nullopt;
  });
}

/// The edges of the causal graph, without those that only preconditions need which another one of the same transition
/// makes superfluous: a mode that lets a cause be concluded from its effect (one engine burns, so there is pressure for
/// the other) is no way to bring it about while there are others.
class CausalGraph {
 public:
  CausalGraph(const automata::Plant& plant, const NominalGraph& graph) {
    std::unordered_map<automata::VariableId, std::size_t> component_of;
    for (std::size_t c = 0; c < plant.components.size(); ++c) component_of.emplace(plant.components[c].mode, c);
    for (std::size_t c = 0; c < plant.components.size(); ++c) {
      auto& transitions = ways_.emplace_back();
      for (const NominalTransition& t : graph.transitions(ComponentId(c))) {
        auto& ways = transitions.emplace_back();
        for (const Precondition& precondition : t.preconditions) {
          auto& way = ways.emplace_back();
          for (const Requirement& r : precondition) {
            if (const auto at = component_of.find(r.variable); at != component_of.end()) way.push_back(at->second);
          }
        }
      }
    }
  }

  [[nodiscard]] Upstream upstream() const {
    Upstream upstream(ways_.size());
    for (std::size_t c = 0; c < upstream.size(); ++c) {
      for (const auto& ways : ways_[c]) {
        for (const auto& way : ways) upstream[c].insert(upstream[c].end(), way.begin(), way.end());
      }
      std::sort(upstream[c].begin(), upstream[c].end());
      upstream[c].erase(std::unique(upstream[c].begin(), upstream[c].end()), upstream[c].end());
    }
    return upstream;
  }

  /// Whether anything was taken away.
  bool cut(const base::StrongComponents& cycles) {
    bool any = false;
    for (std::size_t c = 0; c < ways_.size(); ++c) {
      const auto circular = [&](const std::vector<std::size_t>& way) {
        return std::any_of(way.begin(), way.end(), [&](std::size_t u) { return cycles.number[u] == cycles.number[c]; });
      };
      for (auto& ways : ways_[c]) {
        if (!std::all_of(ways.begin(), ways.end(), circular)) any = std::erase_if(ways, circular) > 0 || any;
      }
    }
    return any;
  }

 private:
  std::vector<std::vector<std::vector<std::vector<std::size_t>>>> ways_;  ///< per component, transition, precondition
};

}  // namespace

CausalOrder::CausalOrder(const automata::Plant& plant, const NominalGraph& graph) : rank_(plant.components.size()) {
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    component_of_.emplace(plant.components[c].mode, ComponentId(c));
  }
  CausalGraph causal(plant, graph);
  while (causal.cut(cycles_of(causal.upstream()))) {
  }
  upstream_ = causal.upstream();
  const Upstream& upstream = upstream_;
  const base::StrongComponents cycles = cycles_of(upstream);
  std::vector<std::vector<std::size_t>> members(cycles.count);
  for (std::size_t c = 0; c < upstream.size(); ++c) members[cycles.number[c]].push_back(c);

  // A cycle's turn comes when all that is downstream of it has had its turn; of several, the first declared.
  std::vector<std::size_t> waits_for(cycles.count);
  for (std::size_t c = 0; c < upstream.size(); ++c) {
    for (const std::size_t u : upstream[c]) {
      if (cycles.number[u] != cycles.number[c]) ++waits_for[cycles.number[u]];
    }
  }
  const auto declared_later = [&](std::size_t a, std::size_t b) { return members[a].front() > members[b].front(); };
  std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(declared_later)> ready(declared_later);
  for (std::size_t k = 0; k < cycles.count; ++k) {
    if (waits_for[k] == 0) ready.push(k);
  }
  while (!ready.empty()) {
    const std::size_t k = ready.top();
    ready.pop();
    for (const std::size_t c : members[k]) {
      rank_[c] = order_.size();
      order_.emplace_back(c);
      for (const std::size_t u : upstream[c]) {
        if (cycles.number[u] != k && --waits_for[cycles.number[u]] == 0) ready.push(cycles.number[u]);
      }
    }
  }
}

bool CausalOrder::goes_upstream(ComponentId component, const Precondition& precondition) const {
  return std::all_of(precondition.begin(), precondition.end(), [&](const Requirement& r) {
    const auto at = component_of_.find(r.variable);
    return at == component_of_.end() || std::binary_search(upstream_[component.index()].begin(),
                                                           upstream_[component.index()].end(), at->second.index());
  });
}

}  // namespace rmpl::runtime
