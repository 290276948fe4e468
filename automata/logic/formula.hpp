// Constraints of propositional state logic with clock bounds (thesis 5.1.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "automata/logic/ids.hpp"
#include "automata/logic/variables.hpp"
#include "automata/time/time.hpp"

namespace rmpl::automata {

enum class Comparison { less, at_most, greater, at_least };

/// A constraint, as a value. Which members mean something depends on `kind`; use the factories below.
struct Formula {
  enum class Kind {
    constant,     ///< `truth`
    member,       ///< `variable` in `values` (sorted, no doubles): covers =, != and in
    equality,     ///< `variable` = `other`, two variables of one domain
    clock,        ///< `clock` `comparison` `bound`
    negation,     ///< not operands[0]
    conjunction,  ///< all of operands
    disjunction,  ///< some of operands
    implication,  ///< operands[0] -> operands[1]
    equivalence   ///< operands[0] <-> operands[1]
  };
  Kind kind = Kind::constant;
  bool truth = true;
  VariableId variable, other;
  std::vector<ValueId> values;
  ClockId clock;
  Comparison comparison = Comparison::less;
  Ticks bound;
  std::vector<Formula> operands;

  bool operator==(const Formula&) const = default;
  [[nodiscard]] bool is_true() const { return kind == Kind::constant && truth; }
};

Formula constant(bool truth);
Formula is(VariableId variable, ValueId value);
Formula member(VariableId variable, std::vector<ValueId> values);
Formula equality(VariableId variable, VariableId other);
Formula clock_bound(ClockId clock, Comparison comparison, Ticks bound);
Formula negation(Formula operand);
Formula conjunction(std::vector<Formula> operands);  ///< of none: true; of one: that one
Formula disjunction(std::vector<Formula> operands);  ///< of none: false; of one: that one
Formula implication(Formula premise, Formula conclusion);
Formula equivalence(Formula left, Formula right);

/// The formula taken apart where it is a conjunction, of conjunctions too; at least one part: `true` is a conjunct of
/// itself.
std::vector<Formula> conjuncts_of(const Formula& formula);

/// Conjunction of assignments.
Formula conjunction_of(std::span<const Assignment> assignments);

/// The truth of a formula without clock atoms under a total assignment; `value_of` gives each variable's value.
bool evaluate(const Formula& formula, const std::function<ValueId(VariableId)>& value_of);

/// The formula with each clock atom replaced by a constant: `value_of(clock)` is the clock's reading, or nothing when
/// it is not active, and then the atom is false (semantics 2). Constants are folded.
Formula with_clocks(const Formula& formula, const std::function<const Ticks*(ClockId)>& value_of);

/// Whether some clock atom occurs.
bool has_clock(const Formula& formula);

/// The variables that occur, sorted, each once.
std::vector<VariableId> variables_of(const Formula& formula);

/// Every variable, value and clock renamed by the given maps (binding a program to a plant).
Formula renamed(const Formula& formula, const std::function<VariableId(VariableId)>& variable,
                const std::function<ValueId(VariableId, ValueId)>& value);

/// In the surface syntax, with no more parentheses than needed; `clocks` names the clocks where there are any.
std::string to_text(const Formula& formula, const Variables& variables, std::span<const std::string> clocks = {});

}  // namespace rmpl::automata
