// What more can be had by reward where the goal is kept (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/reasoning/game/chain.hpp"
#include "runtime/reasoning/game/game.hpp"

namespace rmpl::runtime {

/// The second question of a game. What the executive comes to *at rest*, from a node, is the least total reward among
/// the nodes that resting comes back to for ever.
///
/// From a node where the goal is kept, a reward is pursued if it is more than what resting comes to, and if some
/// strategy surely comes to a node where resting keeps the goal and comes to this reward or more. The strategy stays
/// where the goal is kept and takes no irreversible step. Of all such rewards the greatest is pursued, at the least
/// cost.
///
/// Commands for reward come to an end, though each node is asked anew: what can surely be had never becomes less, and
/// for as long as it stays the same the cost to it falls. Keeps a reference to the game.
class GameRewards {
 public:
  explicit GameRewards(const Game& game);
  GameRewards(const GameRewards&) = delete;
  GameRewards& operator=(const GameRewards&) = delete;

  /// The action that pursues a reward from the node, and the cost of its strategy. Nothing where the goal is not kept,
  /// and where resting is as good.
  struct Pursued {
    std::uint32_t edge;
    Cost cost;
    std::int64_t reward;  ///< at rest, of the arena's components, in millionths
    std::int64_t rest;    ///< what resting comes to
  };
  [[nodiscard]] std::optional<Pursued> from(std::uint32_t node);
  /// With what has been pursued from that node: the action in another node on the way; none at its end.
  [[nodiscard]] std::uint32_t edge(const Pursued& pursued, std::uint32_t node);

 private:
  struct Level {
    std::int64_t reward;
    GameSet target;
    std::optional<Chain> chain;  ///< once it was asked for
  };

  void find_restful();
  void find_values();
  void find_permitted();
  const Chain& chain(Level& level);

  const Game& game_;
  Backward backward_;
  GameSet kept_;
  GameSet restful_;                   ///< where resting keeps the goal
  std::vector<std::int64_t> values_;  ///< by node: what resting comes to, in millionths
  GameSet permitted_;                 ///< by edge
  std::vector<Level> levels_;         ///< the greatest reward first
  std::vector<Cost> no_cost_;
};

}  // namespace rmpl::runtime
