// Finding the preconditions of a guard: what modes and controls bring it about.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "runtime/reasoning/nominal/precondition.hpp"
#include "runtime/reasoning/nominal/regions.hpp"

namespace rmpl::runtime {

/// Finds the preconditions of one guard by abduction over the constraint store (the preconditions of Williams & Nayak
/// 1997, 4.1, without compiling the interactions away first).
///
/// Which modes and controls bring a guard about is a question of two quantifiers: do some modes and controls make it
/// true in all worlds? It is answered by counterexample-guided refinement. A world in which the guard holds proposes
/// its modes and controls. If they imply the guard, the failed assumptions are a precondition; it is shrunk, widened to
/// sets of values, and excluded. If not, a world with the same modes and controls refutes them; it is chosen close to
/// the proposal, and all worlds that the same local change refutes are excluded with it, so that components far from
/// the change are never enumerated.
///
/// A guard is asked conjunct by conjunct: what is enough for a conjunction is enough for each part, so its
/// preconditions are unions of theirs. And each part is asked of its region only, the attributes that constraints join
/// once modes and controls are fixed: those of other regions cannot make it true or false in a consistent state.
class PreconditionFinder {
 public:
  /// Of a guard where a component of the plant is in a mode: all of the plant is looked at.
  PreconditionFinder(const automata::Plant& plant, automata::Assignment source, const automata::Formula& guard);

  /// None when nothing can bring the guard about. Every consistent state and control action that imply the guard fit
  /// one of them, where they are all: no more than `limit` are listed, nor looked for of a conjunct. Sorted: fewest
  /// controls off their idle values first, then fewest requirements, then by variables and values.
  FoundPreconditions preconditions();

  static constexpr std::size_t limit = 256;

 private:
  struct Question;
  using World = std::vector<automata::ValueId>;  ///< by variable

  [[nodiscard]] automata::Theory fresh_theory() const;
  std::vector<Precondition> part_preconditions(Question& question);
  std::vector<Precondition> joined(const std::vector<Precondition>& left, const std::vector<Precondition>& right);
  [[nodiscard]] World read_world() const;
  Precondition shrink(const Question& question);
  void widen(const Question& question, Precondition& precondition);
  World most_tolerant(const Question& question, std::vector<automata::Assignment> assumptions);
  [[nodiscard]] std::vector<bool> swapped(const Question& question, const World& proposal, const World& refuting) const;
  void exclude(const Question& question, const World& proposal);

  automata::Assignment source_;  ///< the component's own mode
  std::vector<automata::Formula> conjuncts_;
  std::vector<automata::VariableId> questions_;               ///< by conjunct
  std::vector<std::vector<automata::VariableId>> tolerates_;  ///< per component, per mode
  automata::Plant plant_;  ///< with those variables: assumed, one asks for a conjunct, or tells a mode's constraint
  std::size_t variables_;  ///< how many it has without them
  automata::Theory theory_;
  std::size_t excluded_ = 0;  ///< by this theory
  bool all_ = true;           ///< none was left out so far
  Regions regions_;
};

}  // namespace rmpl::runtime
