// Strongly connected components of a Markov decision process (R. Tarjan: Depth-first search and linear graph
// algorithms, 1972), without recursion. SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "verifier/markov/decision_process.hpp"

namespace rmpl::verifier {

/// Those of the states for which `among(state)` holds, along the edges of rows for which `counts(state, row)` holds.
/// Each comes after those that it leads to. Linear in states and edges.
template <class Among, class Counts>
std::vector<std::vector<StateNumber>> strong_components(const DecisionProcess& decisions, const Among& among,
                                                        const Counts& counts) {
  constexpr std::uint32_t unseen = 0;
  struct Frame {
    StateNumber state;
    std::size_t row, edge;
  };
  std::vector<std::uint32_t> index(decisions.size(), unseen), low(decisions.size(), 0);
  std::vector<bool> open(decisions.size(), false);
  std::vector<StateNumber> stack;
  std::vector<Frame> frames;
  std::vector<std::vector<StateNumber>> result;
  std::uint32_t next = 0;
  const auto enter = [&](StateNumber s) {
    index[s] = low[s] = ++next;
    open[s] = true;
    stack.push_back(s);
    frames.push_back({s, 0, 0});
  };
  for (std::size_t root = 0; root < decisions.size(); ++root) {
    if (index[root] != unseen || !among(root)) continue;
    enter(static_cast<StateNumber>(root));
    while (!frames.empty()) {
      Frame& frame = frames.back();
      const StateNumber s = frame.state;
      const auto& rows = decisions.rows[s];
      if (frame.row < rows.size()) {
        const Row& row = rows[frame.row];
        if (frame.edge == row.edges.size() || (frame.edge == 0 && !counts(s, row))) {
          ++frame.row;
          frame.edge = 0;
          continue;
        }
        const StateNumber to = row.edges[frame.edge++].to;
        if (!among(to)) continue;
        if (index[to] == unseen) {
          enter(to);
        } else if (open[to]) {
          low[s] = std::min(low[s], index[to]);
        }
        continue;
      }
      if (low[s] == index[s]) {
        auto& set = result.emplace_back();
        StateNumber member;
        do {
          member = stack.back();
          stack.pop_back();
          open[member] = false;
          set.push_back(member);
        } while (member != s);
      }
      frames.pop_back();
      if (!frames.empty()) low[frames.back().state] = std::min(low[frames.back().state], low[s]);
    }
  }
  return result;
}

}  // namespace rmpl::verifier
