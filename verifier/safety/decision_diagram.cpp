// Diagrams: one table of nodes, memories of what was worked out.
// SPDX-License-Identifier: MIT
#include "verifier/safety/decision_diagram.hpp"

#include <algorithm>
#include <queue>

#include "base/hash.hpp"

namespace rmpl::verifier {

std::size_t Diagrams::NodeHash::operator()(const DiagramNode& node) const noexcept {
  return base::mix(base::mix(base::hash_seed, std::uint64_t{node.low} << 32 | node.high), node.variable);
}

Diagrams::Diagrams(Meter& meter) : meter_(meter), nodes_{{no_variable, zero, zero}, {no_variable, one, one}} {}

NodeId Diagrams::node(std::uint32_t variable, NodeId low, NodeId high) {
  const auto [at, fresh] = unique_.try_emplace({variable, low, high}, static_cast<NodeId>(nodes_.size()));
  if (fresh) {
    meter_.poll();
    meter_.count_state();
    nodes_.push_back({variable, low, high});
  }
  return at->second;
}

NodeId Diagrams::make(std::uint32_t variable, NodeId low, NodeId high) {
  return low == high ? low : node(variable, low, high);
}

NodeId Diagrams::make_set(std::uint32_t variable, NodeId low, NodeId high) {
  return high == zero ? low : node(variable, low, high);
}

NodeId Diagrams::variable(std::uint32_t number) { return make(number, zero, one); }

NodeId Diagrams::choose(NodeId f, NodeId g, NodeId h) {
  if (f == one) return g;
  if (f == zero) return h;
  if (g == h) return g;
  if (g == one && h == zero) return f;
  const DiagramNode question{f, g, h};
  if (const auto known = chosen_.find(question); known != chosen_.end()) return known->second;
  const std::uint32_t top = std::min({nodes_[f].variable, nodes_[g].variable, nodes_[h].variable});
  const auto branch = [&](NodeId n, bool high) {
    if (nodes_[n].variable != top) return n;
    return high ? nodes_[n].high : nodes_[n].low;
  };
  const NodeId low = choose(branch(f, false), branch(g, false), branch(h, false));
  const NodeId high = choose(branch(f, true), branch(g, true), branch(h, true));
  const NodeId result = make(top, low, high);
  chosen_.emplace(question, result);
  return result;
}

NodeId Diagrams::minimal_sets(NodeId f) {
  if (f <= one) return f;
  if (const auto known = minimal_.find(f); known != minimal_.end()) return known->second;
  const DiagramNode own = nodes_[f];
  const NodeId low = minimal_sets(own.low);
  const NodeId high = without(minimal_sets(own.high), low);
  const NodeId result = make_set(own.variable, low, high);
  minimal_.emplace(f, result);
  return result;
}

/// Without the sets that hold one of the smaller ones.
NodeId Diagrams::without(NodeId family, NodeId smaller) {
  if (family == zero || smaller == one) return zero;
  if (smaller == zero || family == one) return family;
  const std::uint64_t question = std::uint64_t{family} << 32 | smaller;
  if (const auto known = without_.find(question); known != without_.end()) return known->second;
  const DiagramNode u = nodes_[family];
  const DiagramNode v = nodes_[smaller];
  NodeId result = zero;
  if (u.variable < v.variable) {
    const NodeId low = without(u.low, smaller);
    result = make_set(u.variable, low, without(u.high, smaller));
  } else if (u.variable > v.variable) {
    result = without(family, v.low);
  } else {
    const NodeId low = without(u.low, v.low);
    result = make_set(u.variable, low, without(without(u.high, v.high), v.low));
  }
  without_.emplace(question, result);
  return result;
}

std::vector<NodeId> Diagrams::below(NodeId f) const {
  std::vector<NodeId> result;
  std::vector<bool> seen(nodes_.size(), false);
  std::vector<std::pair<NodeId, bool>> open{{f, false}};
  while (!open.empty()) {
    const auto [n, done] = open.back();
    open.pop_back();
    if (done) {
      result.push_back(n);
      continue;
    }
    if (seen[n]) continue;
    seen[n] = true;
    open.emplace_back(n, true);
    if (n <= one) continue;
    open.emplace_back(nodes_[n].low, false);
    open.emplace_back(nodes_[n].high, false);
  }
  return result;
}

std::vector<Real> Diagrams::sizes(NodeId family) {
  std::unordered_map<NodeId, std::vector<Real>> counts;
  for (const NodeId n : below(family)) {
    meter_.poll();
    auto& own = counts[n];
    if (n <= one) {
      if (n == one) own = {1};
      continue;
    }
    own = counts.at(nodes_[n].low);
    const std::vector<Real>& high = counts.at(nodes_[n].high);
    if (own.size() < high.size() + 1) own.resize(high.size() + 1, 0);
    for (std::size_t size = 0; size < high.size(); ++size) own[size + 1] += high[size];
  }
  return counts.at(family);
}

Enclosure Diagrams::probability(NodeId f, const std::vector<Enclosure>& probabilities) {
  std::vector<Enclosure> values(nodes_.size());
  for (const NodeId n : below(f)) {
    meter_.poll();
    if (n <= one) {
      values[n] = n == one ? certain() : Enclosure{};
      continue;
    }
    const DiagramNode& own = nodes_[n];
    const Enclosure& p = probabilities[own.variable];
    const Enclosure rest{rounding::down(std::max<Real>(1 - p.upper, 0), 1),
                         std::min<Real>(rounding::up(std::max<Real>(1 - p.lower, 0), 1), 1)};
    values[n] = as_probability(p * values[own.high] + rest * values[own.low]);
  }
  return values[f];
}

std::vector<double> Diagrams::birnbaum(NodeId f, const std::vector<double>& probabilities) {
  std::vector<double> values(nodes_.size(), 0);
  const std::vector<NodeId> order = below(f);
  for (const NodeId n : order) {
    if (n <= one) {
      values[n] = n == one ? 1 : 0;
      continue;
    }
    const double p = probabilities[nodes_[n].variable];
    values[n] = p * values[nodes_[n].high] + (1 - p) * values[nodes_[n].low];
  }
  // How likely it is to come to a node, from the top down.
  std::vector<double> met(nodes_.size(), 0);
  std::vector<double> result(probabilities.size(), 0);
  met[f] = 1;
  for (auto at = order.rbegin(); at != order.rend(); ++at) {
    if (*at <= one) continue;
    const DiagramNode& own = nodes_[*at];
    const double p = probabilities[own.variable];
    result[own.variable] += met[*at] * (values[own.high] - values[own.low]);
    met[own.high] += met[*at] * p;
    met[own.low] += met[*at] * (1 - p);
  }
  return result;
}

std::vector<Diagrams::WeighedSet> Diagrams::likeliest(NodeId family, const std::vector<double>& probabilities,
                                                      std::size_t count) {
  // Best first: what is taken so far, times the best that is left.
  std::vector<double> best(nodes_.size(), 0);
  for (const NodeId n : below(family)) {
    if (n <= one) {
      best[n] = n == one ? 1 : 0;
    } else {
      best[n] = std::max(probabilities[nodes_[n].variable] * best[nodes_[n].high], best[nodes_[n].low]);
    }
  }
  struct Partial {
    double bound;
    double taken;
    NodeId at;
    std::vector<std::uint32_t> variables;
  };
  // Of equal ones that with smaller variables.
  const auto worse = [](const Partial& a, const Partial& b) {
    return a.bound != b.bound ? a.bound < b.bound : a.variables > b.variables;
  };
  std::priority_queue<Partial, std::vector<Partial>, decltype(worse)> open(worse);
  open.push({best[family], 1, family, {}});
  std::vector<WeighedSet> result;
  while (!open.empty() && result.size() < count) {
    meter_.poll();
    Partial partial = open.top();
    open.pop();
    if (partial.at == zero) continue;
    if (partial.at == one) {
      result.push_back({std::move(partial.variables), partial.taken});
      continue;
    }
    const DiagramNode& own = nodes_[partial.at];
    if (own.low != zero) open.push({partial.taken * best[own.low], partial.taken, own.low, partial.variables});
    partial.variables.push_back(own.variable);
    partial.taken *= probabilities[own.variable];
    partial.at = own.high;
    partial.bound = partial.taken * best[own.high];
    open.push(std::move(partial));
  }
  return result;
}

}  // namespace rmpl::verifier
