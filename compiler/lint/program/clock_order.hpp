// What clocks that run beside each other can read at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/time/time.hpp"

namespace rmpl::compiler {

/// A clock among others that run, and what is known of its reading: the stretch between two bounds that the reading
/// stands for, or that it is not below it.
struct RunningClock {
  automata::ClockId clock;
  std::size_t rank = 0;  ///< by start: those of one rank were started together, and before those of higher ranks
  automata::Ticks reading;
  bool at_least = false;
};

/// Clocks that were started in one cycle read the same, and one that was started in an earlier cycle reads more than
/// one that was started later (semantics 7).
class ClockOrder {
 public:
  /// Of clocks that are compared with the bounds in these formulas.
  explicit ClockOrder(const std::vector<const automata::Formula*>& formulas);

  /// The least that each can read; nothing, empty, where they cannot read this at once. Sorts them by rank, the highest
  /// first.
  [[nodiscard]] std::vector<automata::Ticks> least(std::vector<RunningClock>& clocks) const;
  /// Where the stretch that a reading stands for begins.
  [[nodiscard]] automata::Ticks first(automata::ClockId clock, automata::Ticks reading) const {
    return stretch_of({clock, 0, reading, false}).first;
  }

 private:
  struct Stretch {
    automata::Ticks first, last;  ///< both within
  };
  [[nodiscard]] Stretch stretch_of(const RunningClock& clock) const;

  std::map<automata::ClockId, std::vector<automata::Ticks>> bounds_;  ///< ascending, from 0
};

}  // namespace rmpl::compiler
