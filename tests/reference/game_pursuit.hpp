// The second question of the game of plans: where the goal is kept, what more can be had by reward.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>

#include "tests/reference/game_board.hpp"

namespace rmpl::reference {

/// What idling comes to, in a node: of the nodes to which what is sent where nothing is wanted comes back for ever, the
/// least total reward.
///
/// A reward r is pursued from a node of K for the greatest r that is more than what idling comes to there, and for
/// which some strategy surely comes to a node where idling keeps the goal and comes to r or more. It goes through nodes
/// of K alone and takes no irreversible step. Of several that which costs least at worst. Keeps references.
class Pursuit {
 public:
  Pursuit(Board& board, const std::set<Node>& kept, Node start);

  [[nodiscard]] double idle() const { return idle_; }
  /// Nothing where nothing is pursued.
  [[nodiscard]] std::optional<double> reward() const { return reward_; }
  [[nodiscard]] const GameCost& cost() const { return states_.at(start_).cost; }
  /// Nothing where the reward is had.
  [[nodiscard]] const Option* option(Node node) const { return states_.at(node).option; }

 private:
  struct State {
    GameCost cost;
    const Option* option = nullptr;
  };
  [[nodiscard]] const Option* rest(Node node) const;
  [[nodiscard]] std::set<Node> rested(Node node) const;
  [[nodiscard]] double value(Node node) const;
  [[nodiscard]] bool may(const Option& option) const;
  [[nodiscard]] std::set<Node> reached() const;
  void solve(const std::set<Node>& nodes, double reward);

  Board& board_;
  const std::set<Node>& kept_;
  Node start_;
  std::set<Node> restful_;  ///< where idling keeps the goal
  double idle_ = 0;
  std::optional<double> reward_;
  std::map<Node, State> states_;
};

}  // namespace rmpl::reference
