// The game of plans, solved by looking at every node: what the executive can have, and how it has it at the least cost.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "tests/reference/game_board.hpp"
#include "tests/reference/game_solve.hpp"

namespace rmpl::reference {

/// What is done in a node of the strategy.
struct Decision {
  enum class Purpose {
    reach,  ///< on the way to the target
    keep,   ///< in K: what keeps the goal; what is sent where nothing is wanted, if that does
    hold,   ///< the goal holds and cannot be kept: what keeps it for as long as it can be
    none    ///< no plan: what is sent where nothing is wanted
  };
  Purpose purpose = Purpose::none;
  const Option* option = nullptr;  ///< none in a dead end of the model
};

/// What can be had; `lasts` where K is reached, and not only a node where the goal holds.
struct Level {
  Rank rank = Rank::none;
  bool lasts = false;
  bool operator==(const Level&) const = default;
};

/// The answer for one start.
struct Solution {
  Level level;
  GameCost cost;  ///< of no meaning where there is no plan
  Commands way;   ///< where there are rewards
  /// From the start on. A node is met before the target of the start's level was reached, or after that, when each
  /// node goes by its own level.
  std::map<std::pair<Node, bool>, Decision> strategy;
};

/// Levels, best first: what surely or fairly comes to K, then to the goal, then what is hoped for K, then for the goal.
///
/// worth: a way is a set of commands, none of which can be spared, that is enough for the level from the start, all
/// controls being left else as where nothing is wanted. Its components, and what its actions can move that does not
/// move anyway, count with their rewards at the end, less those of the start; of other components losses count alone.
/// Where the goal is kept at the end, that is the worst of what keeping it comes back to for ever. Of several ways that
/// which makes the whole cost least is taken, then the first.
///
/// lost: where the goal holds at the end and is lost in the next cycle whatever is done, that counts, too.
///
/// Keeps a reference to the board.
class Game {
 public:
  Game(Board& board, Node start);

  [[nodiscard]] const std::set<Node>& kept() const { return kept_; }
  [[nodiscard]] const std::set<Node>& holding() const { return holding_; }
  [[nodiscard]] const Solution& solution() const { return solution_; }
  /// Of a node that can be reached.
  [[nodiscard]] Level level(Node node) const;

 private:
  /// Towards K, and towards the goal.
  struct Chains {
    Chain lasting;
    Chain passing;
  };
  [[nodiscard]] static Level best(const Chains& chains, Node node);
  [[nodiscard]] May only(const Commands& way) const;
  [[nodiscard]] std::set<Commands> ways(Node start) const;
  [[nodiscard]] std::set<std::size_t> counted(Node start, const Commands& way) const;
  [[nodiscard]] std::set<std::size_t> moved(Node start, const May& may) const;
  [[nodiscard]] Chains chains(Node start, const std::set<std::size_t>& counted) const;
  [[nodiscard]] const Option* rest_option(Node node) const;
  [[nodiscard]] Decision decide(const Chains& chains, Node node, std::optional<Level> bound) const;
  [[nodiscard]] bool keeps(const Option& option) const;
  template <class Counts>
  [[nodiscard]] const Option* least(Node node, const Counts& counts) const;
  [[nodiscard]] const Option* keeping(Node node) const;
  [[nodiscard]] const std::set<Node>& later(Node node) const;
  void find_keeps();
  void find_holds();
  void follow(const Chains& chains, Node start);

  Board& board_;
  May all_;
  std::set<Node> kept_;
  std::set<Node> holding_;
  std::map<Node, const Option*> keeps_;    ///< of K
  std::map<Node, const Option*> longest_;  ///< where the goal holds and cannot be kept
  Solution solution_;
  std::optional<Chains> chains_;
  mutable std::map<Node, std::set<Node>> later_;
};

}  // namespace rmpl::reference
