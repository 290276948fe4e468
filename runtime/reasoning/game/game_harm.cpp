// What must not be risked: harm, and the actions that it forbids (semantics 5).
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/game.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ModeId;

std::uint64_t Game::bit_of(Harm harm) {
  const auto [at, fresh] = harms_.try_emplace(std::move(harm), static_cast<std::uint32_t>(harms_.size()));
  if (at->second >= 63) {
    too_large_ = true;
    return 0;
  }
  return std::uint64_t{1} << at->second;
}

/// What may come of each node if the executive rests: of its step, and of all nodes behind it.
void Game::spread_harm() {
  std::vector<std::vector<std::uint32_t>> before(nodes_.size());
  std::vector<std::uint32_t> changed;
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    Node& node = nodes_[n];
    if (node.count > 0) {
      const Edge& rest = edges_[node.first];
      node.harm = rest.takes;
      for (std::uint32_t o = rest.first; o < rest.first + rest.count; ++o) before[outcomes_[o].node].push_back(n);
    }
    if (node.harm != 0) changed.push_back(n);
  }
  while (!changed.empty()) {
    const std::uint32_t n = changed.back();
    changed.pop_back();
    for (const std::uint32_t earlier : before[n]) {
      const std::uint64_t harm = nodes_[earlier].harm | nodes_[n].harm;
      if (harm == nodes_[earlier].harm) continue;
      nodes_[earlier].harm = harm;
      changed.push_back(earlier);
    }
  }
}

std::uint64_t Game::added_harm(std::uint32_t node, const Edge& edge) const {
  std::uint64_t harm = edge.takes;
  for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) harm |= nodes_[outcomes_[o].node].harm;
  // Unknown harm is never told to be that of resting, but of the edge to rest with.
  const bool rests = &edge == &edges_[nodes_[node].first];
  return harm & ~(nodes_[node].harm & (rests ? ~std::uint64_t{0} : ~unknown_harm));
}

void Game::forbid() {
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    for (std::uint32_t e = nodes_[n].first; e < nodes_[n].first + nodes_[n].count; ++e)
      edges_[e].permitted = !edges_[e].dead && added_harm(n, edges_[e]) == 0;
  }
}

Game::HarmOf Game::harm_of(unsigned bit) const {
  for (const auto& [harm, number] : harms_) {
    if (number != bit) continue;
    HarmOf result{{}, harm.back() == exclusion};
    for (const auto& [c, m] : harm) {
      if (std::pair{c, m} != exclusion) result.modes.emplace_back(ComponentId(c), ModeId(m));
    }
    return result;
  }
  return {{}, false};
}

}  // namespace rmpl::runtime
