// The causal order: what is upstream of what, transitively, then the components by turns.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/causal_order.hpp"

#include <algorithm>
#include <queue>
#include <unordered_map>

namespace rmpl::runtime {

using automata::ComponentId;

namespace {

using Upstream = std::vector<std::vector<std::size_t>>;

/// Tarjan's strongly connected components, with a stack of its own: plants may be deep.
class Cycles {
 public:
  explicit Cycles(const Upstream& upstream)
      : number(upstream.size(), none), upstream_(upstream), index_(upstream.size(), none), low_(upstream.size()) {
    for (std::size_t c = 0; c < upstream.size(); ++c) {
      if (index_[c] == none) visit(c);
    }
  }
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> number;  ///< per component, of its strongly connected component
  std::size_t count = 0;

 private:
  void visit(std::size_t root) {
    struct Frame {
      std::size_t component;
      std::size_t edge;
    };
    std::vector<Frame> frames;
    const auto enter = [&](std::size_t c) {
      index_[c] = low_[c] = visited_++;
      open_.push_back(c);
      frames.push_back({c, 0});
    };
    enter(root);
    while (!frames.empty()) {
      const std::size_t c = frames.back().component;
      if (frames.back().edge < upstream_[c].size()) {
        const std::size_t u = upstream_[c][frames.back().edge++];
        if (index_[u] == none) {
          enter(u);
        } else if (number[u] == none) {
          low_[c] = std::min(low_[c], index_[u]);
        }
        continue;
      }
      frames.pop_back();
      if (!frames.empty()) low_[frames.back().component] = std::min(low_[frames.back().component], low_[c]);
      if (low_[c] == index_[c]) close(c);
    }
  }
  void close(std::size_t root) {
    std::size_t member = none;
    while (member != root) {
      member = open_.back();
      open_.pop_back();
      number[member] = count;
    }
    ++count;
  }

  const Upstream& upstream_;
  std::vector<std::size_t> index_, low_, open_;
  std::size_t visited_ = 0;
};

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
  bool cut(const Cycles& cycles) {
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

CausalOrder::CausalOrder(const automata::Plant& plant, const NominalGraph& graph)
    : rank_(plant.components.size()), in_cycle_(plant.components.size()) {
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    component_of_.emplace(plant.components[c].mode, ComponentId(c));
  }
  CausalGraph causal(plant, graph);
  while (causal.cut(Cycles(causal.upstream()))) {
  }
  upstream_ = causal.upstream();
  const Upstream& upstream = upstream_;
  const Cycles cycles(upstream);
  std::vector<std::vector<std::size_t>> members(cycles.count);
  for (std::size_t c = 0; c < upstream.size(); ++c) members[cycles.number[c]].push_back(c);

  // A cycle's turn comes when all that is downstream of it has had its turn; of several, the first declared.
  std::vector<std::size_t> waits_for(cycles.count);
  for (std::size_t c = 0; c < upstream.size(); ++c) {
    for (const std::size_t u : upstream[c]) {
      if (cycles.number[u] != cycles.number[c]) ++waits_for[cycles.number[u]];
      in_cycle_[c] = in_cycle_[c] || cycles.number[u] == cycles.number[c];
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
