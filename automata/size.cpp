// The size of a plant; clauses are counted, not made.
// SPDX-License-Identifier: MIT
#include "automata/size.hpp"

namespace rmpl::automata {
namespace {

/// Clauses of a formula and of its negation, multiplied out; 0 where it is true, so that nothing is left to say.
struct Clauses {
  std::size_t holds, fails;
};

Clauses count(const Formula& formula, const Variables& variables);

/// A conjunction adds the clauses of its parts and multiplies those of their negations.
Clauses both(Clauses a, Clauses b) {
  return {a.holds + b.holds, a.holds == 0 ? b.fails : b.holds == 0 ? a.fails : a.fails * b.fails};
}
Clauses negated(Clauses c) { return {c.fails, c.holds}; }
Clauses either(Clauses a, Clauses b) { return negated(both(negated(a), negated(b))); }

Clauses count(const Formula& formula, const Variables& variables) {
  switch (formula.kind) {
    case Formula::Kind::constant:
      return formula.truth ? Clauses{0, 1} : Clauses{1, 0};
    case Formula::Kind::clock:
    case Formula::Kind::knowledge:
      return {1, 1};
    case Formula::Kind::member:
      // One of some values is one clause; none of them are as many.
      return {1, formula.values.size()};
    case Formula::Kind::equality: {
      const std::size_t values = variables[formula.variable].values.size();
      return {2 * values, 2 * values};
    }
    case Formula::Kind::negation:
      return negated(count(formula.operands[0], variables));
    case Formula::Kind::conjunction: {
      Clauses all{0, 1};
      for (const Formula& operand : formula.operands) all = both(all, count(operand, variables));
      return all;
    }
    case Formula::Kind::disjunction: {
      Clauses any{1, 0};
      for (const Formula& operand : formula.operands) any = either(any, count(operand, variables));
      return any;
    }
    case Formula::Kind::implication:
      return either(negated(count(formula.operands[0], variables)), count(formula.operands[1], variables));
    case Formula::Kind::equivalence: {
      const Clauses left = count(formula.operands[0], variables);
      const Clauses right = count(formula.operands[1], variables);
      return both(either(negated(left), right), either(left, negated(right)));
    }
  }
  return {0, 0};
}

/// At least one value, and no two of them.
std::size_t exactly_one(std::size_t values) { return 1 + values * (values - 1) / 2; }

}  // namespace

PlantSize size_of(const Plant& plant) {
  PlantSize size;
  for (const Variable& variable : plant.variables) {
    size.propositions += variable.values.size();
    size.clauses += exactly_one(variable.values.size());
  }
  for (const Interconnection& q : plant.interconnections) size.clauses += count(q.constraint, plant.variables).holds;
  for (const Component& component : plant.components) {
    ++size.components;
    size.modes += component.modes.size();
    size.propositions += component.modes.size();
    size.clauses += exactly_one(component.modes.size());
    for (const Mode& mode : component.modes) size.clauses += count(mode.constraint, plant.variables).holds;
    for (const Transition& t : component.transitions) {
      const Clauses guard = count(t.guard, plant.variables);
      size.clauses += guard.fails == 0 ? 1 : guard.fails;
    }
  }
  return size;
}

}  // namespace rmpl::automata
