// The theory of one island: its constraints over its own few variables, so that a question costs what the island is
// worth, not what the plant is.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/store/support.hpp"

namespace rmpl::automata {

/// Keeps references to the plant and to the island, which must outlive it.
class IslandTheory {
 public:
  IslandTheory(const Plant& plant, const Island& island) : plant_(&plant), island_(&island) {}

  [[nodiscard]] const Plant& plant() const { return *plant_; }
  [[nodiscard]] const Island& island() const { return *island_; }
  /// Has the theory know a formula over the island's variables; returns its number. Before the first question.
  std::size_t watch(const Formula& formula);
  /// The theory, made at the first question. Its variables are the modes of the support, then the attributes, then the
  /// controls of the support that are not among these.
  Theory& operator()();
  /// What was watched, by number; once the theory is there.
  [[nodiscard]] const std::vector<Theory::Handle>& watched() const { return handles_; }

  /// A variable of the island, or nothing.
  [[nodiscard]] std::optional<VariableId> own(VariableId variable) const;
  /// The variable of the plant that one of the theory's is.
  [[nodiscard]] VariableId of_plant(VariableId own) const;
  /// What the island reads of them, as the theory's variables.
  [[nodiscard]] std::vector<Assignment> assumptions(const Modes& modes) const;
  [[nodiscard]] std::vector<Assignment> assumptions(const Modes& modes, const ControlAction& action) const;

  [[nodiscard]] std::size_t questions() const { return theory_ ? theory_->questions() : 0; }
  [[nodiscard]] std::size_t solver_calls() const { return theory_ ? theory_->solver_calls() : 0; }

 private:
  [[nodiscard]] VariableId control(std::size_t position) const;

  const Plant* plant_;
  const Island* island_;
  std::vector<Formula> formulas_;        ///< what is watched
  std::vector<Theory::Handle> handles_;  ///< of these
  std::optional<Theory> theory_;
};

}  // namespace rmpl::automata
