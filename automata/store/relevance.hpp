// What of a plant's store has to do with some of its variables: their causes, most often, and none of their effects.
//
// An attribute that always finds a value (elimination.hpp) says nothing of what decides it, so all that only effects
// read is left out. Where components compute their outputs from their inputs, without loops, what is left of the store
// for a guard are the components upstream of it; where constraints exclude each other, all that they read stays
// together.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "automata/dependencies/constraints.hpp"
#include "automata/plant.hpp"

namespace rmpl::automata {

/// Worked out once for a plant, at about the cost of its constraints. Not for use from two threads at once.
class Relevance {
 public:
  explicit Relevance(const Plant& plant);

  /// As `constraints_of` lists them.
  [[nodiscard]] const std::vector<Constraint>& constraints() const { return constraints_; }
  /// Whether some constraint can exclude modes, or commands: nothing takes it away.
  [[nodiscard]] bool excludes() const { return excludes_; }

  struct Part {
    std::vector<VariableId> variables;     ///< ascending, those that were asked for among them
    std::vector<std::size_t> constraints;  ///< positions in `constraints()`, ascending; they read no other variables
  };
  /// The constraints that decide what values the variables can have together. Where the store of the plant has a model
  /// at all, values of the part's variables are those of some model of the store if and only if these constraints
  /// permit them. Costs about the part's size.
  Part part(const std::vector<VariableId>& of);

 private:
  std::vector<Constraint> constraints_;
  std::vector<std::vector<VariableId>> read_;         ///< by constraint, the mode that it is told under among them
  std::vector<std::vector<std::size_t>> decided_by_;  ///< by variable: constraints to look at where it matters
  bool excludes_ = false;
  std::vector<bool> met_, told_;  ///< by variable, by constraint: in the part; false between questions
};

}  // namespace rmpl::automata
