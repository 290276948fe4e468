// Constraints of propositional state logic as written (thesis 5.1.1); names are not resolved.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "grammar/ast/token.hpp"

namespace rmpl::grammar {

struct Constraint;

/// `true`, `false`.
struct Truth {
  bool value = true;
};

/// A bare name: stands for a constraint where it is a parameter of the definition, else it is an error.
struct Reference {
  Name name;
};

/// `x = v`, `x = y`, `x != v`, `x != y`.
struct Comparison {
  Name left;
  bool equal = true;
  Name right;
};

/// `x in {v, w}`. At least one value.
struct Membership {
  Name variable;
  std::vector<Name> values;
};

enum class ClockRelation { less, at_most, greater, at_least };

/// `t1 >= 30 s`. The bound is finite.
struct ClockBound {
  Name clock;
  ClockRelation relation = ClockRelation::less;
  Duration bound;
};

/// What an executive knows of itself and of the plant: `surprise`, `noplan(c)`, `possible(φ)`, `likely(φ, 0.95)`.
struct KnowledgeAtom {
  enum class Kind { surprise, no_plan, possible, likely };
  Kind kind = Kind::surprise;
  std::optional<Name> component;      ///< of the first two, perhaps
  std::vector<Constraint> operands;   ///< of the last two: one
  std::optional<Number> probability;  ///< of `likely`, and of `possible` perhaps
};

/// `!c`. Exactly one operand.
struct Negation {
  std::vector<Constraint> operands;
};

/// `c & d & …`. Two operands or more, as written: a parenthesised conjunction inside is an operand of its own.
struct Conjunction {
  std::vector<Constraint> operands;
};

/// `c | d | …`. Two operands or more.
struct Disjunction {
  std::vector<Constraint> operands;
};

/// `c -> d`. Exactly two operands; `c -> d -> e` is c -> (d -> e).
struct Implication {
  std::vector<Constraint> operands;
};

/// `c <-> d`. Exactly two operands; `c <-> d <-> e` is (c <-> d) <-> e.
struct Equivalence {
  std::vector<Constraint> operands;
};

/// A constraint with its place. Parentheses leave no node: the span of what they enclose grows by them.
struct Constraint {
  Span span;
  std::variant<Truth, Reference, Comparison, Membership, ClockBound, KnowledgeAtom, Negation, Conjunction, Disjunction,
               Implication, Equivalence>
      node;
};

/// `x = v`, in lists of assignments.
struct AssignmentText {
  Span span;
  Name variable;
  Name value;
};

}  // namespace rmpl::grammar
