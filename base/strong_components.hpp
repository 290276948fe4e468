// Strongly connected components of a graph (R. Tarjan: Depth-first search and linear graph algorithms, 1972), without
// recursion. SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace rmpl::base {

struct StrongComponents {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> number;  ///< by node: of its component
  std::size_t count = 0;
};

/// `next(node, i)`: the i-th node that an edge leads to; nothing beyond the last. A component has a smaller number than
/// those that lead to it. Linear in nodes and edges.
template <class Next>
StrongComponents strong_components(std::size_t nodes, const Next& next) {
  constexpr std::size_t none = StrongComponents::none;
  struct Frame {
    std::size_t node, edge;
  };
  StrongComponents result{std::vector<std::size_t>(nodes, none)};
  std::vector<std::size_t> index(nodes, none), low(nodes), open;
  std::vector<Frame> frames;
  std::size_t visited = 0;
  const auto enter = [&](std::size_t node) {
    index[node] = low[node] = visited++;
    open.push_back(node);
    frames.push_back({node, 0});
  };
  for (std::size_t root = 0; root < nodes; ++root) {
    if (index[root] == none) enter(root);
    while (!frames.empty()) {
      const std::size_t node = frames.back().node;
      if (const std::optional<std::size_t> to = next(node, frames.back().edge++)) {
        if (index[*to] == none) {
          enter(*to);
        } else if (result.number[*to] == none) {
          low[node] = std::min(low[node], index[*to]);
        }
        continue;
      }
      frames.pop_back();
      if (!frames.empty()) low[frames.back().node] = std::min(low[frames.back().node], low[node]);
      if (low[node] != index[node]) continue;
      for (std::size_t member = none; member != node;) {
        member = open.back();
        open.pop_back();
        result.number[member] = result.count;
      }
      ++result.count;
    }
  }
  return result;
}

}  // namespace rmpl::base
