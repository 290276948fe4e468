// The one cost of a strategy (semantics 5): entries compared in order, the first that differs decides.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

namespace rmpl::runtime {

/// What a run costs. Entries of steps add up along it; `worth` and `reward` are those of the node in which it ends.
/// The last entry, the declaration order of controls and values, is the order of actions.
struct Cost {
  std::int64_t irreversible = 0;  ///< licensed irreversible steps taken
  std::int64_t lost = 0;          ///< parts of the goal that held and were lost, summed over the steps
  std::int64_t worth = 0;         ///< minus what the way gains in reward, plus what others lose; in millionths
  std::int64_t unbounded = 0;     ///< waits that no bound ends
  std::int64_t time = 0;          ///< ticks until the goal holds, at worst; of a wait that no bound ends, at least
  std::int64_t moves = 0;         ///< actions of one cycle, idle ones too, and commands that are held in a wait
  std::int64_t disturbed = 0;     ///< departures of components that the goal does not read
  std::int64_t commands = 0;      ///< control variables off idle, once for each action or wait
  std::int64_t waits = 0;         ///< idle actions; a wait that something else interrupts is two
  std::int64_t reward = 0;        ///< minus the total reward at the end, in millionths

  auto operator<=>(const Cost&) const = default;

  /// No more than the longest time that there is.
  static constexpr std::int64_t sum_of_times(std::int64_t a, std::int64_t b) {
    constexpr std::int64_t longest = std::numeric_limits<std::int64_t>::max();
    return a > longest - b ? longest : a + b;
  }

  /// This step before those of `rest`.
  friend constexpr Cost operator+(const Cost& step, const Cost& rest) {
    return {step.irreversible + rest.irreversible,
            step.lost + rest.lost,
            step.worth + rest.worth,
            step.unbounded + rest.unbounded,
            sum_of_times(step.time, rest.time),
            step.moves + rest.moves,
            step.disturbed + rest.disturbed,
            step.commands + rest.commands,
            step.waits + rest.waits,
            step.reward + rest.reward};
  }
};

/// What one step costs: the entries of steps, in little room, as a game holds millions of them.
struct StepCost {
  std::int64_t time = 0;
  std::uint16_t irreversible = 0, lost = 0, disturbed = 0, commands = 0;
  std::uint8_t unbounded = 0, moves = 0, waits = 0;

  // NOLINTNEXTLINE(google-explicit-constructor): it is the cost of a run of one step
  constexpr operator Cost() const {
    return {irreversible, lost, 0, unbounded, time, moves, disturbed, commands, waits, 0};
  }
};

}  // namespace rmpl::runtime
