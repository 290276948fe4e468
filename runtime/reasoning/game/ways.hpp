// Which controls are enough, and what that is worth (semantics 5, the third entry of the cost).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "runtime/reasoning/game/chain.hpp"

namespace rmpl::runtime {

/// What can be had from a node: a rank, and whether the goal lasts.
struct Level {
  Rank rank = Rank::none;
  bool lasts = false;
  bool operator==(const Level&) const = default;
};

/// 0 for the best one, the greater the worse (semantics 5, "What can be had").
int level_number(const Level& level);
/// The better one of what can be had towards where the goal can be kept, and towards where it holds.
Level best_level(Rank lasting, Rank passing);

/// Whether a control is the component's own: the constraints of its modes or the guards of its transitions read it.
bool has_control(const automata::Component& component, automata::VariableId control);

/// A *way* is a minimal set of commands that is enough for the level from the start, all controls being left else as
/// where the executive rests. A command is a control with a value; sets of them are bits. Keeps references.
class GameWays {
 public:
  GameWays(const Game& game, const Backward& backward, std::uint32_t start);

  /// Whether the game has few enough commands for a set of bits.
  [[nodiscard]] bool countable() const { return commands_.size() <= 64; }
  /// All ways, but for a bound on the tries; in lexicographic order of their commands.
  [[nodiscard]] std::vector<std::uint64_t> find() const;
  /// By component of the arena: whether it belongs to the way, or is taken along: a command of the way is to a control
  /// of its own, or the way may move it, and nothing does where the executive rests.
  [[nodiscard]] std::vector<bool> counted(std::uint64_t way) const;
  /// A control with a value.
  using Command = std::pair<std::size_t, automata::ValueId>;
  [[nodiscard]] std::vector<Command> commands(std::uint64_t way) const;

 private:
  /// `visit(edge, control, value)`, for what each action of a node commands beside resting.
  template <class Visit>
  void for_each_command(std::uint32_t node, const Visit& visit) const;
  [[nodiscard]] GameSet permitted(std::uint64_t commands) const;
  [[nodiscard]] Level level(std::uint64_t commands) const;
  /// Whether these commands are enough for the best level of all.
  [[nodiscard]] bool have(std::uint64_t commands, Level best) const;
  [[nodiscard]] std::uint64_t shrink(std::uint64_t way, Level wanted) const;
  [[nodiscard]] std::vector<bool> moved(std::uint64_t way) const;

  const Game& game_;
  const Backward& backward_;
  std::uint32_t start_;
  GameSet goal_;
  std::vector<Command> commands_;   ///< ascending
  std::vector<std::uint64_t> off_;  ///< by edge: its commands
};

}  // namespace rmpl::runtime
