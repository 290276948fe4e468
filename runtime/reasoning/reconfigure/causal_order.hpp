// The causal order of components: whose modes let commands through to whom (Williams & Nayak 1997, causal graph).
// SPDX-License-Identifier: MIT
#pragma once

#include <unordered_map>
#include <vector>

#include "runtime/reasoning/nominal/nominal_graph.hpp"

namespace rmpl::runtime {

/// Component u is upstream of c when a transition of c has a precondition that requires modes of u. Preconditions that
/// make a causal cycle do not count where the transition has others.
class CausalOrder {
 public:
  CausalOrder(const automata::Plant& plant, const NominalGraph& graph);

  /// Every component once, those downstream before those upstream of them; the members of a causal cycle stand
  /// together; otherwise in declaration order. Goals are achieved in this order: a driver is turned off last.
  [[nodiscard]] const std::vector<automata::ComponentId>& downstream_first() const { return order_; }
  /// The place of a component in that order, from 0.
  [[nodiscard]] std::size_t rank(automata::ComponentId component) const { return rank_[component.index()]; }

  /// Whether all that the precondition requires counts as upstream of the component.
  [[nodiscard]] bool goes_upstream(automata::ComponentId component, const Precondition& precondition) const;

 private:
  std::unordered_map<automata::VariableId, automata::ComponentId> component_of_;
  std::vector<std::vector<std::size_t>> upstream_;  ///< per component, those directly upstream, ascending
  std::vector<automata::ComponentId> order_;
  std::vector<std::size_t> rank_;
};

}  // namespace rmpl::runtime
