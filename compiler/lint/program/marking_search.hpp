// A search through the markings of a program, with the plant doing whatever its constraints allow.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "automata/step/program_rules.hpp"
#include "compiler/lint/program/free_conditions.hpp"

namespace rmpl::compiler {

/// Two goals that a program asserts in one cycle, and how it comes to that.
struct GoalClash {
  automata::GoalConflict conflict;
  bool certain = false;              ///< one of the two never begins to be asserted but in such a cycle
  std::size_t cycle = 0;             ///< from 1
  std::vector<std::string> history;  ///< of each cycle before, what held at its end; empty: nothing that matters
};

/// How far a search goes. It is cut off by counts, so that it comes out the same everywhere.
struct SearchLimits {
  std::size_t states = 4'000;
  std::size_t steps = 40'000;
  std::size_t questions = 12;  ///< that can be open at the end of a cycle; with more, the state is not followed
};

/// The clashes that can come about: a shortest history for each two locations, in breadth-first order. None is certain
/// where the search was cut off.
///
/// In each cycle the plant may be in any of its states, of those that `conditions` has at the start, after the first
/// cycle and later: modes and observed values are free within domains, interconnections and mode constraints, from one
/// cycle to the next too, and all conditions of a cycle are judged by the same state. Hidden attributes may be unknown.
/// Any time passes from one cycle to the next, the same for all clocks. `relevant`: per location, whether it is looked
/// at; one that is not is taken to do nothing. `conditions`: of this program; it remembers what it was asked.
std::vector<GoalClash> find_goal_clashes(const automata::Program& program, FreeConditions& conditions,
                                         const std::vector<bool>& relevant, const SearchLimits& limits);

}  // namespace rmpl::compiler
