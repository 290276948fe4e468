// The constraint store: finite domains in clauses, formulas by Tseitin's encoding.
// SPDX-License-Identifier: MIT
#include "automata/logic/theory.hpp"

#include <algorithm>
#include <cassert>

namespace automata {

Theory::Theory(const Variables& variables) {
  true_ = sat_.fresh();
  sat_.add({true_});
  literals_.reserve(variables.size());
  for (const Variable& variable : variables) {
    // Two values need one literal; more get one each, exactly one of which holds. An empty domain has no model.
    std::vector<Literal> values;
    if (variable.values.size() == 1) {
      values = {true_};
    } else if (variable.values.size() == 2) {
      const Literal first = sat_.fresh();
      values = {first, -first};
    } else {
      for (std::size_t v = 0; v < variable.values.size(); ++v) values.push_back(sat_.fresh());
      sat_.add(values);
      for (std::size_t v = 0; v < values.size(); ++v) {
        for (std::size_t w = v + 1; w < values.size(); ++w) sat_.add({-values[v], -values[w]});
      }
    }
    literals_.push_back(std::move(values));
  }
}

Literal Theory::literal(Assignment assignment) const {
  return literals_[assignment.variable.index()][assignment.value.index()];
}

void Theory::tell(const Formula& formula) {
  if (formula.kind == Formula::Kind::conjunction) {
    for (const Formula& operand : formula.operands) tell(operand);
    return;
  }
  sat_.add({encode(formula).literal});
}

void Theory::tell_if(Assignment condition, const Formula& formula) {
  sat_.add({-literal(condition), encode(formula).literal});
}

Literal Theory::encode_gate(const Formula& formula, bool conjunctive) {
  // A disjunction is the negation of the conjunction of the negations: one gate serves both.
  const int sign = conjunctive ? 1 : -1;
  const Literal gate = sat_.fresh();
  std::vector<Literal> closing{gate};
  for (const Formula& operand : formula.operands) {
    const Literal input = sign * encode(operand).literal;
    sat_.add({-gate, input});
    closing.push_back(-input);
  }
  sat_.add(closing);
  return sign * gate;
}

Theory::Handle Theory::encode(const Formula& formula) {
  switch (formula.kind) {
    case Formula::Kind::constant:
      return {formula.truth ? true_ : -true_};
    case Formula::Kind::member: {
      const auto& values = literals_[formula.variable.index()];
      if (formula.values.empty()) return {-true_};
      if (formula.values.size() == values.size()) return {true_};
      if (formula.values.size() == 1) return {values[formula.values[0].index()]};
      const Literal gate = sat_.fresh();
      std::vector<Literal> closing{-gate};
      for (const ValueId v : formula.values) {
        sat_.add({-values[v.index()], gate});
        closing.push_back(values[v.index()]);
      }
      sat_.add(closing);
      return {gate};
    }
    case Formula::Kind::equality: {
      const auto& left = literals_[formula.variable.index()];
      const auto& right = literals_[formula.other.index()];
      assert(left.size() == right.size() && "an equality compares variables of one domain");
      const Literal gate = sat_.fresh();
      for (std::size_t v = 0; v < left.size(); ++v) {
        sat_.add({-gate, -left[v], right[v]});
        sat_.add({gate, -left[v], -right[v]});
      }
      return {gate};
    }
    case Formula::Kind::clock:
      assert(false && "clock atoms are replaced before encoding");
      return {-true_};
    case Formula::Kind::negation:
      return {-encode(formula.operands[0]).literal};
    case Formula::Kind::conjunction:
      return {encode_gate(formula, true)};
    case Formula::Kind::disjunction:
      return {encode_gate(formula, false)};
    case Formula::Kind::implication: {
      const Literal premise = encode(formula.operands[0]).literal;
      const Literal conclusion = encode(formula.operands[1]).literal;
      const Literal gate = sat_.fresh();
      sat_.add({-gate, -premise, conclusion});
      sat_.add({gate, premise});
      sat_.add({gate, -conclusion});
      return {gate};
    }
    case Formula::Kind::equivalence: {
      const Literal left = encode(formula.operands[0]).literal;
      const Literal right = encode(formula.operands[1]).literal;
      const Literal gate = sat_.fresh();
      sat_.add({-gate, -left, right});
      sat_.add({-gate, left, -right});
      sat_.add({gate, left, right});
      sat_.add({gate, -left, -right});
      return {gate};
    }
  }
  return {true_};
}

bool Theory::solve(std::span<const Assignment> assumptions, Literal extra) {
  assumed_.clear();
  for (const Assignment& a : assumptions) assumed_.push_back(literal(a));
  assumed_.push_back(extra);
  const bool possible = sat_.solve(assumed_);
  conflict_.clear();
  if (!possible) {
    for (std::size_t i = 0; i < assumptions.size(); ++i) {
      if (sat_.failed(assumed_[i])) conflict_.push_back(assumptions[i]);
    }
  }
  return possible;
}

bool Theory::consistent(std::span<const Assignment> assumptions) { return solve(assumptions, true_); }

bool Theory::allows(std::span<const Assignment> assumptions, Handle formula) {
  return solve(assumptions, formula.literal);
}

bool Theory::entails(std::span<const Assignment> assumptions, Handle formula) {
  return !solve(assumptions, -formula.literal);
}

bool Theory::entails(std::span<const Assignment> assumptions, Assignment assignment) {
  return !solve(assumptions, -literal(assignment));
}

ValueId Theory::value(VariableId variable) const {
  const auto& values = literals_[variable.index()];
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (sat_.value(values[v])) return ValueId(v);
  }
  assert(false && "each variable has a value in a model");
  return {};
}

}  // namespace automata
