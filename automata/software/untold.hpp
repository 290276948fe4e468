// When a store does not imply something, as a formula over modes and controls.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "automata/dependencies/dependencies.hpp"
#include "automata/dependencies/known_attributes.hpp"
#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/store/support.hpp"

namespace rmpl::automata {

/// A plant's guard asks what the store implies; a model program asks also what it does not imply. The store is known
/// once all modes and the command are: so a formula over these says whether it implies another one. Keeps a reference
/// to the plant, whose transitions it does not look at.
class Untold {
 public:
  explicit Untold(const Plant& plant);

  /// A formula that a consistent store of a state with this mode, and of a command, implies where it does not imply
  /// `constraint`, and refutes where it does. Throws base::LimitError where too many modes and controls decide it.
  Formula of(const Formula& constraint, Assignment mode);
  /// Whether some state with this mode, and some command, can imply a formula.
  bool possible(const Formula& formula, Assignment mode);

 private:
  /// What decides a formula, as a tree over its support.
  struct Decided {
    Formula untold;     ///< over modes and controls
    bool open = false;  ///< in some state the store implies neither the formula nor its negation
  };
  std::optional<Decided> decide(Theory::Handle formula, std::size_t next);
  const Decided& decided(const Formula& formula, Assignment mode);
  [[nodiscard]] Formula otherwise(const Formula& formula) const;
  bool settled(const Formula& formula, Assignment mode);

  const Plant& plant_;
  Dependencies dependencies_;
  KnownAttributes known_;
  Locality locality_;
  Theory theory_;
  std::vector<VariableId> order_;  ///< what is looked at for the formula in question, one after the other
  std::vector<Assignment> assumed_;
  std::size_t questions_ = 0;
  std::vector<std::pair<std::pair<Formula, Assignment>, Decided>> answers_;
};

}  // namespace rmpl::automata
