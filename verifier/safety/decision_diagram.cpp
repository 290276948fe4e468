// Diagrams: one table of nodes, memories of what was worked out.
// SPDX-License-Identifier: MIT
#include "verifier/safety/decision_diagram.hpp"

#include <algorithm>
#include <queue>
#include <utility>

#include "base/hash.hpp"

namespace rmpl::verifier {

namespace {

/// So many places at first.
constexpr std::size_t first_places = std::size_t{1} << 12;
/// Then so many times as many.
constexpr std::size_t growth = 4;

std::uint64_t hash_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return base::mix(base::mix(base::hash_seed, std::uint64_t{a} << 32 | b), c);
}

}  // namespace

Diagrams::Diagrams(Meter& meter)
    : meter_(meter), nodes_{{no_variable, zero, zero}, {no_variable, one, one}}, unique_(first_places, zero) {
  chosen_.places.resize(first_places);
  without_.places.resize(first_places);
}

/// Where the node is, or where it would be.
std::size_t Diagrams::slot(const DiagramNode& node) const {
  const std::size_t mask = unique_.size() - 1;
  std::size_t at = hash_of(node.variable, node.low, node.high) & mask;
  while (unique_[at] != zero && !(nodes_[unique_[at]] == node)) at = (at + 1) & mask;
  return at;
}

Diagrams::Known& Diagrams::place(Memory& memory, NodeId f, NodeId g, NodeId h) {
  return memory.places[hash_of(f, g, h) & (memory.places.size() - 1)];
}

void Diagrams::grow() {
  unique_.assign(growth * unique_.size(), zero);
  for (NodeId n = one + 1; n < nodes_.size(); ++n) unique_[slot(nodes_[n])] = n;
}

/// There is a place for every second answer: the older ones are seldom asked for again.
void Diagrams::remember(Memory& memory, const Known& known) {
  if (++memory.answers > 2 * memory.places.size()) {
    const std::vector<Known> before = std::exchange(memory.places, std::vector<Known>(growth * memory.places.size()));
    for (const Known& answer : before) {
      if (answer.f != zero) place(memory, answer.f, answer.g, answer.h) = answer;
    }
  }
  place(memory, known.f, known.g, known.h) = known;
}

NodeId Diagrams::node(std::uint32_t variable, NodeId low, NodeId high) {
  const DiagramNode own{variable, low, high};
  const std::size_t at = slot(own);
  if (unique_[at] != zero) return unique_[at];
  meter_.poll();
  meter_.count_state();
  const auto result = static_cast<NodeId>(nodes_.size());
  nodes_.push_back(own);
  unique_[at] = result;
  if (2 * nodes_.size() > unique_.size()) grow();
  return result;
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
  if (f == g) g = one;
  if (f == h) h = zero;
  if (g == h) return g;
  if (g == one && h == zero) return f;
  // Conjunctions and disjunctions are the same either way round.
  if (h == zero && f > g) std::swap(f, g);
  if (g == one && f > h) std::swap(f, h);
  if (const Known& known = place(chosen_, f, g, h); known.f == f && known.g == g && known.h == h) return known.answer;
  const DiagramNode a = nodes_[f];
  const DiagramNode b = nodes_[g];
  const DiagramNode c = nodes_[h];
  const std::uint32_t top = std::min({a.variable, b.variable, c.variable});
  const auto low_of = [top](const DiagramNode& node, NodeId n) { return node.variable == top ? node.low : n; };
  const auto high_of = [top](const DiagramNode& node, NodeId n) { return node.variable == top ? node.high : n; };
  const NodeId low = choose(low_of(a, f), low_of(b, g), low_of(c, h));
  const NodeId high = choose(high_of(a, f), high_of(b, g), high_of(c, h));
  const NodeId result = make(top, low, high);
  remember(chosen_, {f, g, h, result});
  return result;
}

NodeId Diagrams::minimal_sets(NodeId f) {
  if (f <= one) return f;
  if (minimal_.size() <= f) minimal_.resize(nodes_.size(), unknown);
  if (minimal_[f] != unknown) return minimal_[f];
  const DiagramNode own = nodes_[f];
  const NodeId low = minimal_sets(own.low);
  const NodeId high = without(minimal_sets(own.high), low);
  const NodeId result = make_set(own.variable, low, high);
  minimal_[f] = result;
  return result;
}

/// Without the sets that hold one of the smaller ones.
NodeId Diagrams::without(NodeId family, NodeId smaller) {
  if (family == zero || smaller == one || family == smaller) return zero;
  if (smaller == zero || family == one) return family;
  // What is tested above the family is in none of its sets.
  while (nodes_[smaller].variable < nodes_[family].variable) {
    smaller = nodes_[smaller].low;
    if (smaller == zero) return family;
  }
  if (smaller == one || family == smaller) return zero;
  if (const Known& known = place(without_, family, smaller, zero); known.f == family && known.g == smaller) {
    return known.answer;
  }
  const DiagramNode u = nodes_[family];
  const DiagramNode v = nodes_[smaller];
  NodeId result = zero;
  if (u.variable < v.variable) {
    const NodeId low = without(u.low, smaller);
    result = make_set(u.variable, low, without(u.high, smaller));
  } else {
    const NodeId low = without(u.low, v.low);
    result = make_set(u.variable, low, without(without(u.high, v.high), v.low));
  }
  remember(without_, {family, smaller, zero, result});
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
  const std::vector<NodeId> order = below(family);
  const std::vector<NodeId> at = positions(order);
  std::vector<std::vector<Real>> counts(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    meter_.poll();
    std::vector<Real>& own = counts[i];
    if (order[i] <= one) {
      if (order[i] == one) own = {1};
      continue;
    }
    own = counts[at[nodes_[order[i]].low]];
    const std::vector<Real>& high = counts[at[nodes_[order[i]].high]];
    if (own.size() < high.size() + 1) own.resize(high.size() + 1, 0);
    for (std::size_t size = 0; size < high.size(); ++size) own[size + 1] += high[size];
  }
  return counts.back();
}

std::vector<NodeId> Diagrams::positions(const std::vector<NodeId>& nodes) const {
  std::vector<NodeId> result(nodes_.size(), unknown);
  for (NodeId i = 0; i < nodes.size(); ++i) result[nodes[i]] = i;
  return result;
}

Enclosure Diagrams::probability(NodeId f, const std::vector<Enclosure>& probabilities) {
  const std::vector<NodeId> order = below(f);
  const std::vector<NodeId> at = positions(order);
  std::vector<Enclosure> values;
  values.reserve(order.size());
  for (const NodeId n : order) {
    meter_.poll();
    if (n <= one) {
      values.push_back(n == one ? certain() : Enclosure{});
      continue;
    }
    const DiagramNode& own = nodes_[n];
    const Enclosure& p = probabilities[own.variable];
    const Enclosure rest{rounding::down(std::max<Real>(1 - p.upper, 0), 1),
                         std::min<Real>(rounding::up(std::max<Real>(1 - p.lower, 0), 1), 1)};
    values.push_back(as_probability(p * values[at[own.high]] + rest * values[at[own.low]]));
  }
  return values.back();
}

std::vector<double> Diagrams::birnbaum(NodeId f, const std::vector<double>& probabilities) {
  const std::vector<NodeId> order = below(f);
  const std::vector<NodeId> at = positions(order);
  std::vector<double> values;
  values.reserve(order.size());
  for (const NodeId n : order) {
    if (n <= one) {
      values.push_back(n == one ? 1 : 0);
      continue;
    }
    const double p = probabilities[nodes_[n].variable];
    values.push_back(p * values[at[nodes_[n].high]] + (1 - p) * values[at[nodes_[n].low]]);
  }
  // How likely it is to come to a node, from the top down.
  std::vector<double> met(order.size(), 0);
  std::vector<double> result(probabilities.size(), 0);
  met.back() = 1;
  for (std::size_t i = order.size(); i-- > 0;) {
    if (order[i] <= one) continue;
    const DiagramNode& own = nodes_[order[i]];
    const double p = probabilities[own.variable];
    result[own.variable] += met[i] * (values[at[own.high]] - values[at[own.low]]);
    met[at[own.high]] += met[i] * p;
    met[at[own.low]] += met[i] * (1 - p);
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
