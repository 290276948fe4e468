// The game as a graph: every node that permitted actions lead to, what may never be sent in it, and what each step
// costs. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <vector>

#include "automata/logic/formula.hpp"
#include "tests/reference/game_arena.hpp"
#include "tests/reference/game_cost.hpp"
#include "tests/reference/game_rules.hpp"

namespace rmpl::reference {

/// What no goal asks for, and what an action must not bring: an unlicensed irreversible step of a component, or modes
/// that contradict each other.
struct Harm {
  Nogood modes;                        ///< of a step: its component and source
  std::optional<automata::ModeId> to;  ///< of a step
  auto operator<=>(const Harm&) const = default;
};
using Harms = std::set<Harm>;

/// Controls with values that they would not have where nothing is wanted.
using Commands = std::set<std::pair<std::size_t, automata::ValueId>>;

/// A permitted action.
struct Option {
  GameStep::Action action;
  bool waits;
  bool ends;
  bool at_once;
  std::vector<Commands> commands;  ///< of all actions that let the same happen, each once, those with more left out
  struct Way {
    Node to;
    GameCost cost;         ///< of this step
    std::int64_t soonest;  ///< ticks
    std::size_t chosen;    ///< ways with the same number differ by chance alone
    bool irreversible;     ///< something irreversible is taken, licensed or not
    bool coincides;        ///< something timed comes in the very cycle of a command
  };
  std::vector<Way> ways;
};

/// More nodes than the board was to have.
class GameTooLarge : public std::runtime_error {
 public:
  GameTooLarge() : runtime_error("the game has too many nodes") {}
};

/// harm(n): the unlicensed irreversible steps, and the contradictions of outcomes of components each taken by itself,
/// that may come from n where nothing is commanded, be it after any number of steps. An action is forbidden in n where
/// one of its outcomes takes, contradicts or leads to what is not in harm(n).
///
/// "Nothing is commanded" is the idle action; where that contradicts the model, the first action that does not by:
/// fewest controls off idle, fewest components that leave at once, order. It counts, too, where nothing can come of it:
/// what contradicts itself then is what may come.
///
/// Of actions that let the same happen only the one with the fewest controls off idle counts, then the first.
class Board {
 public:
  Board(Arena& arena, const automata::Formula& goal, const std::set<std::size_t>& progress = {},
        std::size_t most_nodes = 1U << 16);

  [[nodiscard]] Arena& arena() const { return arena_; }
  [[nodiscard]] GameStep& step() const { return arena_.step(); }
  /// Explores what permitted actions lead to from a node.
  void explore(Node start);
  /// In order of node.
  [[nodiscard]] const std::map<Node, std::vector<Option>>& nodes() const { return options_; }
  [[nodiscard]] const std::vector<Option>& options(Node node) const { return options_.at(node); }
  /// Whether the goal holds.
  bool holds(Node node);
  const Harms& harms(Node node);
  /// What is sent where nothing is wanted; nothing in a dead end of the model.
  std::optional<GameStep::Action> rest(Node node);
  /// Whether an action that turns out so does no harm that could not come anyway.
  bool permits(Node node, const Turn& turn);
  /// Rewards of the modes, by component.
  [[nodiscard]] double reward(Node node, std::size_t component) const;

 private:
  const std::vector<bool>& parts(Node node);
  const std::optional<Turn>& turn(Node node, GameStep::Action action);
  Harms harms_of(Node node, const Turn& turn);
  std::vector<GameStep::Action> different_actions(Node node);
  std::vector<Commands> commands_of(Node node, GameStep::Action action);
  Option option(Node node, GameStep::Action action, const Turn& turn);
  [[nodiscard]] bool reads(std::size_t component) const { return read_[component]; }

  Arena& arena_;
  std::vector<automata::Formula> goal_;  ///< its conjuncts
  Irreversible irreversible_;
  std::vector<bool> read_;  ///< by component, whether the goal reads its mode or an attribute
  std::size_t most_nodes_;
  std::map<automata::Modes, std::vector<bool>> parts_;
  std::map<std::pair<Node, GameStep::Action>, std::optional<Turn>> turns_;
  std::map<Node, Harms> harms_;
  std::map<Node, std::optional<GameStep::Action>> rest_;
  std::map<Node, std::vector<Option>> options_;
};

}  // namespace rmpl::reference
