// Binary decision diagrams of a structure function, and its minimal cut sets as a zero-suppressed one.
//
// Nodes are shared: equal functions are one node, so that a function of thousands of events whose parts repeat stays
// small (R. Bryant: Graph-based algorithms for Boolean function manipulation, 1986). Minimal solutions are found on the
// diagram, without listing any (A. Rauzy: New algorithms for fault trees analysis, 1993).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "verifier/markov/enclosure.hpp"
#include "verifier/search/limits.hpp"

namespace rmpl::verifier {

/// A function, or a family of sets: a node of `Diagrams`.
using NodeId = std::uint32_t;

/// All nodes, of both kinds. Variables are numbers; smaller ones are tested first.
class Diagrams {
 public:
  static constexpr NodeId zero = 0;  ///< false; no set
  static constexpr NodeId one = 1;   ///< true; the empty set alone

  /// Keeps a reference. A node counts as a state of the meter, which ends what grows too large by throwing
  /// LimitReached.
  explicit Diagrams(Meter& meter);

  NodeId variable(std::uint32_t number);
  /// The variable that a node tests; constants test none, and that is the greatest number.
  [[nodiscard]] std::uint32_t tested(NodeId f) const { return nodes_[f].variable; }
  NodeId negation(NodeId f) { return choose(f, zero, one); }
  NodeId conjunction(NodeId f, NodeId g) { return choose(f, g, zero); }
  NodeId disjunction(NodeId f, NodeId g) { return choose(f, one, g); }
  /// If f then g, else h.
  NodeId choose(NodeId f, NodeId g, NodeId h);

  /// The minimal sets of variables that make the function true with all others false, of a function that is monotone.
  NodeId minimal_sets(NodeId f);
  /// Of a family of sets, by size: how many there are; as far as a long double counts them.
  std::vector<Real> sizes(NodeId family);

  /// The probability of the function, where variables are independent.
  Enclosure probability(NodeId f, const std::vector<Enclosure>& probabilities);
  /// By variable: how much the probability grows where the variable becomes true for certain from false for certain.
  std::vector<double> birnbaum(NodeId f, const std::vector<double>& probabilities);

  struct WeighedSet {
    std::vector<std::uint32_t> variables;
    double probability;
  };
  /// So many sets of a family at most, the likeliest first.
  std::vector<WeighedSet> likeliest(NodeId family, const std::vector<double>& probabilities, std::size_t count);

 private:
  static constexpr std::uint32_t no_variable = std::numeric_limits<std::uint32_t>::max();
  static constexpr NodeId unknown = std::numeric_limits<NodeId>::max();
  struct DiagramNode {
    std::uint32_t variable;
    NodeId low, high;
    bool operator==(const DiagramNode&) const = default;
  };
  /// A question of three nodes, or of two, and its answer; f is no constant where there is one.
  struct Known {
    NodeId f = zero, g = zero, h = zero, answer = zero;
  };
  /// What was worked out, a place a hash: a newer answer takes the place of an older one.
  struct Memory {
    std::vector<Known> places;
    std::size_t answers = 0;
  };

  NodeId node(std::uint32_t variable, NodeId low, NodeId high);
  NodeId make(std::uint32_t variable, NodeId low, NodeId high);  ///< of a function
  NodeId make_set(std::uint32_t variable, NodeId low, NodeId high);
  NodeId without(NodeId family, NodeId smaller);
  /// The nodes under one, each after those under it.
  [[nodiscard]] std::vector<NodeId> below(NodeId f) const;
  /// By node, where it stands among these.
  [[nodiscard]] std::vector<NodeId> positions(const std::vector<NodeId>& nodes) const;

  void grow();
  [[nodiscard]] std::size_t slot(const DiagramNode& node) const;
  static Known& place(Memory& memory, NodeId f, NodeId g, NodeId h);
  static void remember(Memory& memory, const Known& known);

  Meter& meter_;
  std::vector<DiagramNode> nodes_;
  std::vector<NodeId> unique_;  ///< nodes by hash, with open addressing; `zero` where there is none
  Memory chosen_;
  Memory without_;
  std::vector<NodeId> minimal_;  ///< by node; `unknown`: not asked yet
};

}  // namespace rmpl::verifier
