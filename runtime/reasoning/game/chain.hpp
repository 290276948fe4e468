// Strategies towards one target: the best rank of each node, and its least cost.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/reasoning/game/cost.hpp"
#include "runtime/reasoning/game/game.hpp"
#include "runtime/reasoning/game/solve.hpp"

namespace rmpl::runtime {

/// By node, or by edge.
using GameSet = std::vector<bool>;

/// Edges into each node.
struct Backward {
  struct Arc {
    std::uint32_t edge, outcome;
  };
  std::vector<std::vector<Arc>> into;  ///< by node
  std::vector<std::uint32_t> node_of;  ///< by edge

  explicit Backward(const Game& game);
};

/// The greatest set of nodes where the goal holds and a permitted action has all outcomes in the set. Where actions
/// take no time, some of them have to lead to a wait: time has to pass in the set.
GameSet kept_nodes(const Game& game, const Backward& backward, const GameSet& permitted);
/// By edge: whether it may be sent to keep the goal. Where actions take no time, all outcomes are nearer to a wait; by
/// resting where that leads to one.
GameSet keeping_edges(const Game& game, const Backward& backward, const GameSet& permitted, const GameSet& kept);

/// From where permitted actions lead to the target on every run. Cost: the outcomes of the game.
GameSet sure_nodes(const Game& game, const Backward& backward, const GameSet& permitted, const GameSet& target);

/// Ranks are solved best first; where an outcome has a better one, its own cost counts there. Keeps references.
class Chain {
 public:
  struct State {
    Rank rank = Rank::none;
    Cost cost;
    std::uint32_t edge = GameDecision::no_edge;  ///< none in the target
  };

  /// `permitted`: by edge. `terminal`: by node, what a run costs that ends there; empty where nothing.
  Chain(const Game& game, const Backward& backward, const GameSet& permitted, const GameSet& target,
        const std::vector<Cost>& terminal);

  [[nodiscard]] const State& at(std::uint32_t node) const { return states_[node]; }

 private:
  [[nodiscard]] GameSet fair_nodes() const;
  /// `within`: nodes that the strategy must not leave; all where it is null.
  void solve(Rank rank, const GameSet* within);
  [[nodiscard]] bool stays(const Game::Edge& edge, const GameSet& nodes) const;
  [[nodiscard]] bool may_come(const Game::Edge& edge, const GameSet& nodes) const;
  [[nodiscard]] std::optional<Cost> cost(Rank rank, const Game::Edge& edge) const;

  const Game& game_;
  const Backward& backward_;
  const GameSet& permitted_;
  const GameSet& target_;
  std::vector<State> states_;
};

}  // namespace rmpl::runtime
