// What follows from what, by looking at every assignment of the variables: the twin of automata/logic.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::reference {

/// A value for each variable, by position.
using World = std::vector<automata::ValueId>;

/// The reading of each clock, by position; nothing where the clock is not active.
using Clocks = std::vector<std::optional<automata::Ticks>>;

/// Whether a formula is true in a world. An atom over a clock that is not active is false (semantics 2).
bool holds(const automata::Formula& formula, const World& world, const Clocks& clocks = {});

/// All worlds that a model permits. Cost: the product of all domains, so for small models only.
class Models {
 public:
  /// The worlds in which Q holds and each component satisfies the constraint of the mode it is in.
  explicit Models(const automata::Plant& plant);
  /// Every assignment of the variables.
  explicit Models(const automata::Variables& variables);

  [[nodiscard]] bool consistent(const std::vector<automata::Assignment>& assumptions) const;
  /// Whether some world of the model satisfies assumptions and formula.
  [[nodiscard]] bool allows(const std::vector<automata::Assignment>& assumptions,
                            const automata::Formula& formula) const;
  /// Whether the formula holds in every world that satisfies the assumptions; also where there is none.
  [[nodiscard]] bool entails(const std::vector<automata::Assignment>& assumptions, const automata::Formula& formula,
                             const Clocks& clocks = {}) const;

  /// The worlds of the model that satisfy the assumptions.
  [[nodiscard]] const std::vector<const World*>& matching(std::vector<automata::Assignment> assumptions) const;

 private:
  std::vector<World> worlds_;
  mutable std::map<std::vector<automata::Assignment>, std::vector<const World*>>
      matching_;  ///< the same question again
};

/// The assignments that a state of the plant makes: the mode variable of each component.
std::vector<automata::Assignment> assumptions_of(const automata::Plant& plant, const automata::Modes& modes);
/// Those of a control action.
std::vector<automata::Assignment> assumptions_of(const automata::Plant& plant, const automata::ControlAction& action);
/// Those of both.
std::vector<automata::Assignment> assumptions_of(const automata::Plant& plant, const automata::Modes& modes,
                                                 const automata::ControlAction& action);

/// Every tuple that takes its i-th member from 0 … sizes[i] - 1, in lexicographic order.
std::vector<std::vector<std::size_t>> tuples(const std::vector<std::size_t>& sizes);

}  // namespace rmpl::reference
