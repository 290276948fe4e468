// What the executive can have in the game of plans, by fixpoints over all nodes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "tests/reference/game_board.hpp"

namespace rmpl::reference {

/// How surely a strategy reaches its target; best first.
enum class Rank { sure, fair, hoped, none };

/// Which of the permitted actions count.
using May = std::function<bool(Node, const Option&)>;

/// K, the largest set of nodes in which the goal holds and a permitted action leads to nodes of K alone, whatever comes
/// of it. Resting for ever counts.
std::set<Node> kept(Board& board, const May& may);

/// Of a node: how surely the target can be reached from there (`Chain`).
Rank rank_of(const Board& board, Node node, const std::set<Node>& target, const May& may);

/// What the least strategies towards one target come to, from every node.
///
/// sure: the least set with the target in which some permitted action leads to nodes of the set alone, and, where it is
/// a wait, must end. fair: the greatest set in which some permitted action stays, and from which, whatever nature
/// chooses, chance may bring it nearer to the target. hoped: some run leads there.
/// A sure strategy is charged its worst run; a fair one what nature chooses at worst and chance brings at best; a hoped
/// one the best run, in which what comes by time in the very cycle of a command counts as a wait without bound. Where
/// an action leads to a node of better rank, that node's own strategy goes on.
class Chain {
 public:
  /// `terminal`: what is charged in a node of the target.
  Chain(const Board& board, const std::set<Node>& target, const std::function<GameCost(Node)>& terminal,
        const May& may);

  [[nodiscard]] Rank rank(Node node) const;
  /// Of a node whose rank is not none.
  [[nodiscard]] const GameCost& cost(Node node) const { return states_.at(node).cost; }
  /// Of those that cost least what does something now before what waits, then the first; nothing in the target.
  [[nodiscard]] const Option* option(Node node) const { return states_.at(node).option; }

 private:
  struct State {
    Rank rank;
    GameCost cost;
    const Option* option = nullptr;
  };
  void solve(Rank rank, const std::set<Node>& within);
  [[nodiscard]] std::optional<GameCost> cost(Rank rank, const Option& option, const std::set<Node>& within) const;

  const Board& board_;
  const May& may_;
  std::map<Node, State> states_;
};

}  // namespace rmpl::reference
