// A tree of counters that grow on demand.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/totalizer.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::runtime {

using automata::Literal;

Totalizer::Totalizer(std::span<const Literal> inputs) {
  CHECK(!inputs.empty());
  nodes_.reserve(2 * inputs.size());
  build(inputs);
}

std::size_t Totalizer::build(std::span<const Literal> inputs) {
  if (inputs.size() == 1) {
    nodes_.push_back({1, nodes_.size(), nodes_.size(), {inputs[0]}});
  } else {
    const std::size_t left = build(inputs.first(inputs.size() / 2));
    const std::size_t right = build(inputs.subspan(inputs.size() / 2));
    nodes_.push_back({inputs.size(), left, right, {}});
  }
  return nodes_.size() - 1;
}

Literal Totalizer::more_than(std::size_t count, automata::Sat& sat) {
  CHECK(count < size());
  extend(nodes_.size() - 1, count + 1, sat);
  return nodes_.back().outputs[count];
}

/// The i-th output holds if i + 1 inputs do: those of i + 1 = l + r, l of them on the left and r on the right.
void Totalizer::extend(std::size_t at, std::size_t outputs, automata::Sat& sat) {
  Node& node = nodes_[at];
  outputs = std::min(outputs, node.size);
  if (node.outputs.size() >= outputs) return;
  extend(node.left, outputs, sat);
  extend(node.right, outputs, sat);
  const std::vector<Literal>& left = nodes_[node.left].outputs;
  const std::vector<Literal>& right = nodes_[node.right].outputs;
  while (node.outputs.size() < outputs) {
    const Literal output = sat.fresh();
    node.outputs.push_back(output);
    const std::size_t sum = node.outputs.size();
    for (std::size_t l = sum - std::min(sum, right.size()); l <= std::min(sum, left.size()); ++l) {
      const std::size_t r = sum - l;
      if (l == 0) {
        sat.add({output, -right[r - 1]});
      } else if (r == 0) {
        sat.add({output, -left[l - 1]});
      } else {
        sat.add({output, -left[l - 1], -right[r - 1]});
      }
    }
  }
}

}  // namespace rmpl::runtime
