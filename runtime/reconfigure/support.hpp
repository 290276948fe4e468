// Supports: what must hold of other components' modes and of the controls for a guard to be implied.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/plant.hpp"
#include "runtime/reconfigure/islands.hpp"

namespace runtime {

/// A mode variable or a control variable must have one of these values (sorted, at least one).
struct Requirement {
  automata::VariableId variable;
  std::vector<automata::ValueId> values;
  auto operator<=>(const Requirement&) const = default;
};

/// Requirements, in order of variable, that together with the component's own mode make the store imply a guard,
/// whichever of the permitted values are taken. None of them can be left out.
using Support = std::vector<Requirement>;

/// Whether a support can be met with every control at its idle value.
bool needs_no_command(const automata::Plant& plant, const Support& support);

/// Finds supports by abduction over the constraint store (the preconditions of Williams & Nayak 1997, 4.1, without
/// compiling the interactions away first).
///
/// Which modes and controls support a guard is a question of two quantifiers: do some modes and controls make it true
/// in all worlds? It is answered by counterexample-guided refinement. A world in which the guard holds proposes its
/// modes and controls. If they imply the guard, the failed assumptions are a support; it is shrunk, widened to sets of
/// values, and excluded. If not, a world with the same modes and controls refutes them; it is chosen close to the
/// proposal, and all worlds that the same local change refutes are excluded with it, so that components far from the
/// change are never enumerated.
class SupportFinder {
 public:
  SupportFinder(const automata::Plant& plant, const Islands& islands);

  /// The supports of a transition's guard in its source mode; none when nothing can bring the guard about. Every
  /// consistent state and control action that imply the guard fit one of them, unless there are more than `limit`.
  /// Sorted: fewest controls off their idle values first, then fewest requirements, then by variables and values.
  std::vector<Support> supports(automata::ComponentId component, automata::TransitionId transition);

  /// Whether some state of the plant has this mode.
  bool possible(automata::ComponentId component, automata::ModeId mode);

  static constexpr std::size_t limit = 256;

 private:
  struct Question;
  using World = std::vector<automata::ValueId>;  ///< by variable; of the island only

  World read_world(const Question& question) const;
  Support shrink(const Question& question);
  void widen(const Question& question, Support& support);
  void exclude(const Question& question, const World& proposal);

  std::vector<std::vector<automata::VariableId>> questions_;  ///< per component, per transition
  automata::Plant plant_;  ///< with one more variable for each transition: assumed, it asks for that guard
  const Islands& islands_;
  automata::Theory theory_;
};

}  // namespace runtime
