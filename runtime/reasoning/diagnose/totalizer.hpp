// Counting literals in clauses, as far as one has to count.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "automata/logic/sat.hpp"

namespace rmpl::runtime {

/// A totalizer (Bailleux and Boufkhad 2003) whose outputs are added when they are asked for (Martins, Joshi, Manquinho
/// and Lynce 2014): of large sets it is mostly asked whether two hold, which takes clauses linear in the set, while all
/// outputs would take quadratically many. Only "inputs imply outputs" is told: an output may hold without cause.
class Totalizer {
 public:
  explicit Totalizer(std::span<const automata::Literal> inputs);

  [[nodiscard]] std::size_t size() const { return nodes_.back().size; }
  /// The literal that holds if more than `count` inputs do; `count` is below `size`. The solver must always be the
  /// same.
  automata::Literal more_than(std::size_t count, automata::Sat& sat);

 private:
  struct Node {
    std::size_t size;
    std::size_t left, right;  ///< positions of the halves, before this one; of a leaf its own
    std::vector<automata::Literal> outputs;
  };
  std::size_t build(std::span<const automata::Literal> inputs);
  void extend(std::size_t node, std::size_t outputs, automata::Sat& sat);

  std::vector<Node> nodes_;  ///< the root last
};

}  // namespace rmpl::runtime
