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

/// What a condition can ask of an executive's knowledge (semantics 2).
enum class Knowing {
  surprise,  ///< a reading was set aside in this cycle
  no_plan,   ///< a goal that was asserted in this cycle had no plan
  possible,  ///< some tracked state that is likely enough is consistent with operands[0]
  likely     ///< the tracked states that entail operands[0] are likely enough together
};

/// The probability of `possible(φ)` that names none.
inline constexpr double least_possible = 0.001;

/// A constraint, as a value. Which members mean something depends on `kind`; use the factories below.
struct Formula {
  enum class Kind {
    constant,   ///< `truth`
    member,     ///< `variable` in `values` (sorted, no doubles): covers =, != and in
    equality,   ///< `variable` = `other`, two variables of one domain
    clock,      ///< `clock` `comparison` `bound`
    knowledge,  ///< `knowing`; of `surprise` and `no_plan`: about the component of `variable`, where it is `about_one`;
                ///< of the others: operands[0], which has neither clocks nor knowledge, and `probability`
    negation,   ///< not operands[0]
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
  Knowing knowing = Knowing::surprise;
  bool about_one = false;
  double probability = 0;
  std::vector<Formula> operands;

  bool operator==(const Formula&) const = default;
  [[nodiscard]] bool is_true() const { return kind == Kind::constant && truth; }
};

Formula constant(bool truth);
Formula is(VariableId variable, ValueId value);
Formula member(VariableId variable, std::vector<ValueId> values);
Formula equality(VariableId variable, VariableId other);
Formula clock_bound(ClockId clock, Comparison comparison, Ticks bound);
Formula knowledge(Knowing knowing);                        ///< `surprise`, `noplan`
Formula knowledge(Knowing knowing, VariableId component);  ///< `surprise(c)`, `noplan(c)`, by the mode variable
Formula knowledge(Knowing knowing, Formula operand, double probability);  ///< `possible(φ, p)`, `likely(φ, p)`
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

/// The truth of a formula without atoms of clocks or knowledge under a total assignment; `value_of` gives each
/// variable's value.
bool evaluate(const Formula& formula, const std::function<ValueId(VariableId)>& value_of);

/// The formula with each clock atom replaced by a constant: `value_of(clock)` is the clock's reading, or nothing when
/// it is not active, and then the atom is false (semantics 2). Constants are folded.
Formula with_clocks(const Formula& formula, const std::function<const Ticks*(ClockId)>& value_of);

/// Whether some clock atom occurs.
bool has_clock(const Formula& formula);

/// The formula with each atom of knowledge replaced by its answer. Constants are folded.
Formula with_knowledge(const Formula& formula, const std::function<bool(const Formula& atom)>& answer);

/// Whether some atom of knowledge occurs.
bool has_knowledge(const Formula& formula);

/// Whether states alone decide it: neither a clock atom nor one of knowledge occurs.
bool is_of_states(const Formula& formula);

/// Adds the atoms of knowledge of the formula that are not yet among `atoms`, in the order in which they occur.
void collect_knowledge(const Formula& formula, std::vector<Formula>& atoms);

/// The variables that occur, those of what is asked for as knowledge included; sorted, each once.
std::vector<VariableId> variables_of(const Formula& formula);

/// Every variable, value and clock renamed by the given maps (binding a program to a plant).
Formula renamed(const Formula& formula, const std::function<VariableId(VariableId)>& variable,
                const std::function<ValueId(VariableId, ValueId)>& value);

/// In the surface syntax, with no more parentheses than needed; `clocks` names the clocks where there are any.
std::string to_text(const Formula& formula, const Variables& variables, std::span<const std::string> clocks = {});

}  // namespace rmpl::automata
