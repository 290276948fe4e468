// The game once more, with all that is forbidden.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/barrier.hpp"

#include <bit>
#include <vector>

#include "runtime/reasoning/game/chain.hpp"

namespace rmpl::runtime {

std::optional<Game::HarmOf> barrier(const Game& game, std::uint32_t start) {
  const Backward backward(game);
  GameSet possible(game.edges().size()), goal(game.nodes().size());
  for (std::uint32_t e = 0; e < possible.size(); ++e) possible[e] = !game.edges()[e].dead;
  for (std::uint32_t n = 0; n < goal.size(); ++n) goal[n] = game.position(n).goal;
  const std::vector<Cost> no_cost;
  const Chain chain(game, backward, possible, goal, no_cost);
  std::uint32_t node = start;
  while (chain.at(node).rank != Rank::none && chain.at(node).edge != GameDecision::no_edge) {
    const Game::Edge& edge = game.edges()[chain.at(node).edge];
    if (const std::uint64_t harm = game.added_harm(node, edge); harm != 0)
      return game.harm_of(static_cast<unsigned>(std::countr_zero(harm)));
    // The outcome of least cost from there on; costs of steps are positive, so the run comes to an end.
    std::optional<Cost> least;
    std::uint32_t next = node;
    for (std::uint32_t o = edge.first; o < edge.first + edge.count; ++o) {
      const Game::Outcome& outcome = game.outcomes()[o];
      if (chain.at(outcome.node).rank == Rank::none) continue;
      const Cost cost = outcome.cost + chain.at(outcome.node).cost;
      if (least && *least <= cost) continue;
      least = cost;
      next = outcome.node;
    }
    if (next == node) break;
    node = next;
  }
  return std::nullopt;
}

}  // namespace rmpl::runtime
