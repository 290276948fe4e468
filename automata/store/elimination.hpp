// Elimination: attributes that always find a value are taken away, with all constraints that read them.
//
// An attribute may go where the constraints that still read it leave it a value whatever all other variables are: then
// they exclude nothing, and go with it. That frees others. Where components compute their outputs from their inputs,
// without loops, effects go before their causes, and in the end nothing is left; no direction need be declared.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "automata/dependencies/constraints.hpp"

namespace rmpl::automata {

/// Takes away all of some attributes that may go. Which of them go, and what is left, does not depend on the order in
/// which they go.
class Elimination {
 public:
  /// Keeps a reference to the variables.
  Elimination(const Variables& variables, const std::vector<Constraint>& constraints,
              const std::vector<VariableId>& attributes);

  [[nodiscard]] bool has_gone(VariableId attribute) const { return gone_.contains(attribute); }
  /// Positions of the constraints that an attribute took away when it went, ascending. All that they read beside it
  /// went later or is still there, so what is left says of other variables what it did before.
  [[nodiscard]] const std::set<std::size_t>& taken_by(VariableId attribute) const { return gone_.at(attribute); }
  /// Of an attribute that has gone, by value of `given`, by value: whether what it took away leaves it another value
  /// than this, whatever all other variables are, where `given` has its value. Then no store in which it has implies
  /// the value: what went before the attribute finds a value yet. Where what is told is one value under each of n, this
  /// takes time of order n, and n^2 bits.
  [[nodiscard]] std::vector<std::vector<bool>> leaves_another(VariableId attribute, VariableId given) const;
  /// Positions of the constraints that nothing has taken away, ascending.
  [[nodiscard]] const std::set<std::size_t>& left() const { return left_; }

 private:
  /// Positions of constraints by the value of a variable that they are told under, and of those that are not.
  struct Division {
    std::map<ValueId, std::vector<std::size_t>> under;
    std::vector<std::size_t> always;
  };
  /// The constraints that say something where `given` holds, with it fixed, and the variables that they read beside an
  /// attribute.
  struct Case {
    std::vector<Formula> formulas;
    std::vector<VariableId> others;
  };
  using Contradicted = std::vector<Formula>;  ///< by value of the attribute: what excludes it

  [[nodiscard]] bool always_has_a_value(VariableId attribute) const;
  [[nodiscard]] Division divide(const std::set<std::size_t>& constraints, std::optional<VariableId> under) const;
  [[nodiscard]] Case case_of(const Division& constraints, VariableId attribute, std::optional<Assignment> given) const;
  [[nodiscard]] std::vector<bool> leaves_another(const Case& given, VariableId attribute) const;
  [[nodiscard]] Contradicted contradicted(const Case& given, VariableId attribute) const;
  /// Whether every assignment to the variables leaves a value that is not excluded.
  [[nodiscard]] bool always_left(const Case& given, VariableId attribute) const;
  /// The variable that most of the constraints are told under, if any.
  [[nodiscard]] std::optional<VariableId> mostly_under(const std::set<std::size_t>& constraints) const;
  [[nodiscard]] std::size_t combinations_of(const std::vector<VariableId>& variables) const;
  template <class Visit>
  bool any_combination(const std::vector<VariableId>& variables, const Visit& visit) const;
  [[nodiscard]] bool solvable(Contradicted parts, const std::vector<VariableId>& variables) const;
  [[nodiscard]] std::size_t values_of(VariableId variable) const { return variables_[variable].values.size(); }
  void take_away(std::size_t constraint);

  struct Told {
    Formula formula;  ///< with the mode that it is told under
    std::vector<VariableId> variables;
    std::optional<Assignment> under;
  };

  const Variables& variables_;
  std::vector<Told> told_;
  std::set<std::size_t> left_;
  std::map<VariableId, std::set<std::size_t>> gone_;     ///< with the constraints that they took away
  std::map<VariableId, std::set<std::size_t>> readers_;  ///< of the attributes that are still there
  std::set<std::pair<std::size_t, VariableId>> open_;    ///< number of readers, attribute: not looked at since
};

}  // namespace rmpl::automata
