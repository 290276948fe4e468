// Whether some store entails a formula: two solvers that answer each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/logic/ids.hpp"
#include "automata/logic/theory.hpp"
#include "automata/logic/variables.hpp"

namespace rmpl::compiler {

/// A part of a model program: variables, what stands, what may be told, and the variables whose value may be told as it
/// comes. Everything that a question about the formula can depend on.
struct StorePart {
  automata::Variables variables;
  std::vector<automata::Formula> standing;
  std::vector<std::pair<automata::LocationId, automata::Formula>> tellable;  ///< where it is marked
  std::vector<automata::VariableId> free;
};

/// Is there a consistent store that entails the formula? One solver proposes a store, with a world that shows it to be
/// consistent; the other looks for a world of it in which the formula fails; from then on a store has to exclude that
/// world. Exact, but for a limit on the proposals.
class Entailment {
 public:
  Entailment(StorePart part, automata::Formula formula);

  /// Whether some of what is told where only these locations are ever marked makes the formula follow. Once it did, it
  /// does, so the marked ones may only become more.
  bool may_hold(const std::vector<bool>& marked);
  /// Whether what stands leaves the formula open, or refutes it.
  bool may_fail();

 private:
  void exclude_world();

  StorePart part_;
  std::vector<automata::VariableId> selectors_;  ///< per tellable, added to the variables of the part
  automata::Formula formula_;
  automata::Theory stores_;  ///< proposes
  automata::Theory worlds_;  ///< refutes
  bool held_ = false;
};

}  // namespace rmpl::compiler
