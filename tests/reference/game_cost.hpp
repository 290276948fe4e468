// What a strategy of the game costs: entries that are compared one after the other.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>

#include "tests/reference/game_arena.hpp"

namespace rmpl::reference {

/// Entries are added up along a run, but for `worth` and `reward`, which are charged at its end.
struct GameCost {
  std::size_t irreversible = 0;  ///< licensed irreversible steps
  std::size_t lost = 0;          ///< parts of the goal (its conjuncts) that held before a step, and do not after it
  double worth = 0;              ///< minus what the rewards of the way have gained, plus what others have lost
  Span time;                     ///< until the target
  std::size_t moves = 0;         ///< actions of one cycle, idle ones too, and commands that are held in a wait
  std::size_t disturbed = 0;     ///< departures of components that the goal does not read
  std::size_t commands = 0;      ///< controls off idle, once for each action or wait
  std::size_t waits = 0;         ///< idle actions; a wait that something else interrupts is two
  double reward = 0;             ///< minus the total reward of the state that it comes to

  std::partial_ordering operator<=>(const GameCost&) const = default;
};

inline GameCost operator+(const GameCost& a, const GameCost& b) {
  return {a.irreversible + b.irreversible,
          a.lost + b.lost,
          a.worth + b.worth,
          {a.time.unbounded + b.time.unbounded, a.time.ticks + b.time.ticks},
          a.moves + b.moves,
          a.disturbed + b.disturbed,
          a.commands + b.commands,
          a.waits + b.waits,
          a.reward + b.reward};
}

}  // namespace rmpl::reference
