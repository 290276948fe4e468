// What the states of a plant can satisfy, decided by a solver; and what stands in the way of the rest.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/logic/theory.hpp"
#include "automata/logic/variables.hpp"
#include "automata/origin.hpp"
#include "automata/plant.hpp"
#include "automata/time/time.hpp"

namespace rmpl::compiler {

/// The bounds that formulas compare each clock with, as they come.
std::map<automata::ClockId, std::vector<automata::Ticks>> clock_bounds_of(
    const std::vector<const automata::Formula*>& formulas);

/// The readings that formulas tell apart: per clock, one from each stretch between the bounds that it is compared with,
/// and each bound itself, ascending.
using ClockCuts = std::map<automata::ClockId, std::vector<automata::Ticks>>;
ClockCuts cuts_of(const std::vector<const automata::Formula*>& formulas);

/// The table of a plant, or of a program without a plant: then a variable may have values that nobody mentions, so
/// each has one more.
automata::Variables open_table(const automata::Variables& variables, const automata::Plant* plant);

/// Judges formulas by all states there are: domains, interconnections, mode constraints. Clocks may read anything, or
/// be inactive.
class Possibilities {
 public:
  /// `plant` is null for a program without one. Refers to the plant.
  Possibilities(const automata::Variables& variables, const automata::Plant* plant);

  /// Whether there is a state at all; where there is none, nothing that follows means anything.
  [[nodiscard]] bool consistent();
  bool can_hold(const automata::Formula& formula);
  bool can_fail(const automata::Formula& formula) { return can_hold(automata::negation(formula)); }
  /// Of a formula that cannot hold: the interconnections and modes whose constraints it contradicts, few of them; none
  /// where it contradicts itself.
  std::vector<automata::Origin> blame(const automata::Formula& formula);

 private:
  bool holds_somewhere(const automata::Formula& formula);

  const automata::Plant* plant_;
  automata::Variables variables_;
  automata::Theory theory_;
  std::vector<std::vector<automata::ValueId>> worlds_;  ///< states that the solver found; most questions are about one
};

/// Calls `visit` with the formula for each way that its clocks can read and what it asks of the executive's knowledge
/// can be answered, until it returns true. Whether it did. A formula with too many such ways counts as one where it
/// did.
bool for_some_reading(const automata::Formula& formula, const std::function<bool(const automata::Formula&)>& visit);

}  // namespace rmpl::compiler
