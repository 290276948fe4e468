// The game, solved backward: ranks, where the goal can be kept, and the least cost (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/reasoning/game/cost.hpp"
#include "runtime/reasoning/game/game.hpp"
#include "runtime/reasoning/game/rank.hpp"

namespace rmpl::runtime {

/// What can be had from a node, and what is done there.
struct GameDecision {
  enum class Purpose : std::uint8_t {
    reach,  ///< on the way to the target
    keep,   ///< the goal holds and can be kept: what keeps it, resting where that does
    hold,   ///< the goal holds and cannot be kept: what keeps it for the longest time
    none    ///< no strategy
  };
  static constexpr std::uint32_t no_edge = static_cast<std::uint32_t>(-1);
  Purpose purpose = Purpose::none;
  Rank rank = Rank::none;
  bool lasts = false;            ///< the target is where the goal can be kept
  std::uint32_t edge = no_edge;  ///< into `Game::edges`; none in a dead end of the model
  Cost cost;                     ///< to the target: of the worst run of a sure strategy, else of the run hoped for
};

/// Solves a game for one of its nodes. Levels, best first: surely and fairly to where the goal can be kept, surely and
/// fairly to where it holds, then what is hoped for.
///
/// Time: about the outcomes of the game, times a logarithm, for each way. Knuth's generalization of Dijkstra's
/// algorithm (1977) over AND-OR graphs, and nested fixpoints for the fair rank (Cimatti, Pistore, Roveri and Traverso
/// 2003).
class Solution {
 public:
  /// `start`: what a component gains in reward counts only if it is on the way that is taken from this node, or is
  /// taken along.
  Solution(const Game& game, std::uint32_t start);
  /// `counted`: by way, the components of the arena whose gains count.
  Solution(const Game& game, std::uint32_t start, const std::vector<std::vector<bool>>& counted);

  /// From a node, after the target of its level too.
  [[nodiscard]] const GameDecision& at(std::uint32_t node) const { return decisions_[node]; }
  /// By node: whether the goal can be kept there.
  [[nodiscard]] const std::vector<bool>& kept() const { return kept_; }
  /// Whether no rewards tell the nodes apart, so that it is the same from each of them.
  [[nodiscard]] bool is_of_all_nodes() const { return of_all_nodes_; }

 private:
  void solve(const Game& game, std::uint32_t start, const std::vector<std::vector<bool>>* counted);

  bool of_all_nodes_ = true;
  std::vector<GameDecision> decisions_;
  std::vector<bool> kept_;
};

}  // namespace rmpl::runtime
