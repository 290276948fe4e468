// What follows from what: a constraint store over finite domains, asked by assumptions.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/logic/sat.hpp"
#include "automata/logic/variables.hpp"

namespace automata {

/// The constraint store of thesis 6.1: permanent constraints (the interconnections Q, and each mode's constraint under
/// its mode), and questions under assumptions. One incremental solver lives behind it; formulas are encoded once.
/// Every question is asked of: the permanent constraints, each variable having exactly one value, and the assumptions.
class Theory {
 public:
  /// A formula that this theory has encoded. Cheap to copy; valid for this theory only.
  struct Handle {
    Literal literal;
  };

  explicit Theory(const Variables& variables);

  /// Adds a permanent constraint. No clock atoms.
  void tell(const Formula& formula);
  /// Adds `condition -> formula` as a permanent constraint.
  void tell_if(Assignment condition, const Formula& formula);
  /// Encodes a formula (equivalence with a fresh literal), once; keep the handle. No clock atoms.
  Handle encode(const Formula& formula);

  /// Whether store and assumptions can hold together. On false, `conflict()` names the assumptions to blame.
  bool consistent(std::span<const Assignment> assumptions);
  /// Whether store, assumptions and the formula can hold together.
  bool allows(std::span<const Assignment> assumptions, Handle formula);
  /// Whether store and assumptions imply the formula; an inconsistent store implies everything.
  bool entails(std::span<const Assignment> assumptions, Handle formula);
  bool entails(std::span<const Assignment> assumptions, Assignment assignment);

  /// After `consistent` or `allows` returned false: assumptions that contradict the store by themselves (a conflict in
  /// the sense of livingstone), in the order in which they were given. Not always minimal.
  [[nodiscard]] const std::vector<Assignment>& conflict() const { return conflict_; }
  /// After `consistent` or `allows` returned true: the value of a variable in the model found.
  [[nodiscard]] ValueId value(VariableId variable) const;
  [[nodiscard]] std::size_t solver_calls() const { return sat_.calls(); }

 private:
  bool solve(std::span<const Assignment> assumptions, Literal extra);
  Literal literal(Assignment assignment) const;
  Literal encode_gate(const Formula& formula, bool conjunctive);

  Sat sat_;
  std::vector<std::vector<Literal>> literals_;  ///< per variable, per value
  Literal true_;
  std::vector<Literal> assumed_;
  std::vector<Assignment> conflict_;
};

}  // namespace automata
