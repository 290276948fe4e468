// Constraints of propositional state logic: construction, evaluation, rewriting.
// SPDX-License-Identifier: MIT
#include "automata/logic/formula.hpp"

#include <algorithm>
#include <utility>

#include "automata/logic/folding.hpp"
#include "base/check.hpp"

namespace rmpl::automata {
namespace {

Formula node(Formula::Kind kind, std::vector<Formula> operands) {
  Formula formula;
  formula.kind = kind;
  formula.operands = std::move(operands);
  return formula;
}

bool compare(Ticks reading, Comparison comparison, Ticks bound) {
  switch (comparison) {
    case Comparison::less:
      return reading < bound;
    case Comparison::at_most:
      return reading <= bound;
    case Comparison::greater:
      return reading > bound;
    case Comparison::at_least:
      return reading >= bound;
  }
  return false;
}

template <class Visit>
void visit_atoms(const Formula& formula, const Visit& visit) {
  if (formula.operands.empty()) visit(formula);
  for (const Formula& operand : formula.operands) visit_atoms(operand, visit);
}

}  // namespace

Formula constant(bool truth) {
  Formula formula;
  formula.truth = truth;
  return formula;
}

Formula is(VariableId variable, ValueId value) { return member(variable, {value}); }

Formula member(VariableId variable, std::vector<ValueId> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  Formula formula;
  formula.kind = Formula::Kind::member;
  formula.variable = variable;
  formula.values = std::move(values);
  return formula;
}

Formula equality(VariableId variable, VariableId other) {
  Formula formula;
  formula.kind = Formula::Kind::equality;
  formula.variable = variable;
  formula.other = other;
  return formula;
}

Formula clock_bound(ClockId clock, Comparison comparison, Ticks bound) {
  Formula formula;
  formula.kind = Formula::Kind::clock;
  formula.clock = clock;
  formula.comparison = comparison;
  formula.bound = bound;
  return formula;
}

Formula knowledge(Knowing knowing) {
  Formula formula;
  formula.kind = Formula::Kind::knowledge;
  formula.knowing = knowing;
  return formula;
}

Formula knowledge(Knowing knowing, VariableId component) {
  Formula formula = knowledge(knowing);
  formula.about_one = true;
  formula.variable = component;
  return formula;
}

Formula knowledge(Knowing knowing, Formula operand, double probability) {
  Formula formula = knowledge(knowing);
  formula.operands.push_back(std::move(operand));
  formula.probability = probability;
  return formula;
}

Formula negation(Formula operand) {
  std::vector<Formula> operands;
  operands.push_back(std::move(operand));
  return node(Formula::Kind::negation, std::move(operands));
}

Formula conjunction(std::vector<Formula> operands) {
  if (operands.empty()) return constant(true);
  if (operands.size() == 1) return std::move(operands.front());
  return node(Formula::Kind::conjunction, std::move(operands));
}

Formula disjunction(std::vector<Formula> operands) {
  if (operands.empty()) return constant(false);
  if (operands.size() == 1) return std::move(operands.front());
  return node(Formula::Kind::disjunction, std::move(operands));
}

Formula implication(Formula premise, Formula conclusion) {
  return node(Formula::Kind::implication, {std::move(premise), std::move(conclusion)});
}

Formula equivalence(Formula left, Formula right) {
  return node(Formula::Kind::equivalence, {std::move(left), std::move(right)});
}

namespace {

void collect_conjuncts(const Formula& formula, std::vector<Formula>& conjuncts) {
  if (formula.kind != Formula::Kind::conjunction) {
    conjuncts.push_back(formula);
    return;
  }
  for (const Formula& operand : formula.operands) collect_conjuncts(operand, conjuncts);
}

}  // namespace

std::vector<Formula> conjuncts_of(const Formula& formula) {
  std::vector<Formula> conjuncts;
  collect_conjuncts(formula, conjuncts);
  if (conjuncts.empty()) conjuncts.push_back(constant(true));
  return conjuncts;
}

Formula conjunction_of(std::span<const Assignment> assignments) {
  std::vector<Formula> operands;
  operands.reserve(assignments.size());
  for (const Assignment& a : assignments) operands.push_back(is(a.variable, a.value));
  return conjunction(std::move(operands));
}

bool evaluate(const Formula& formula, const std::function<ValueId(VariableId)>& value_of) {
  const auto& operands = formula.operands;
  const auto holds = [&](const Formula& operand) { return evaluate(operand, value_of); };
  switch (formula.kind) {
    case Formula::Kind::constant:
      return formula.truth;
    case Formula::Kind::member:
      return std::binary_search(formula.values.begin(), formula.values.end(), value_of(formula.variable));
    case Formula::Kind::equality:
      return value_of(formula.variable) == value_of(formula.other);
    case Formula::Kind::clock:
    case Formula::Kind::knowledge:
      CHECK(false && "atoms of clocks and knowledge are replaced before evaluation");
      return false;
    case Formula::Kind::negation:
      return !holds(operands[0]);
    case Formula::Kind::conjunction:
      return std::all_of(operands.begin(), operands.end(), holds);
    case Formula::Kind::disjunction:
      return std::any_of(operands.begin(), operands.end(), holds);
    case Formula::Kind::implication:
      return !holds(operands[0]) || holds(operands[1]);
    case Formula::Kind::equivalence:
      return holds(operands[0]) == holds(operands[1]);
  }
  return false;
}

Formula folded(Formula::Kind kind, std::vector<Formula> operands) {
  const auto is_constant = [](const Formula& f, bool truth) {
    return f.kind == Formula::Kind::constant && f.truth == truth;
  };
  switch (kind) {
    case Formula::Kind::negation:
      if (operands[0].kind == Formula::Kind::constant) return constant(!operands[0].truth);
      break;
    case Formula::Kind::conjunction:
    case Formula::Kind::disjunction: {
      const bool neutral = kind == Formula::Kind::conjunction;
      if (std::any_of(operands.begin(), operands.end(), [&](const auto& f) { return is_constant(f, !neutral); })) {
        return constant(!neutral);
      }
      std::erase_if(operands, [&](const Formula& f) { return is_constant(f, neutral); });
      return neutral ? conjunction(std::move(operands)) : disjunction(std::move(operands));
    }
    case Formula::Kind::implication:
      if (is_constant(operands[0], false) || is_constant(operands[1], true)) return constant(true);
      if (is_constant(operands[0], true)) return std::move(operands[1]);
      if (is_constant(operands[1], false)) return negation(std::move(operands[0]));
      break;
    case Formula::Kind::equivalence:
      for (const std::size_t i : {0u, 1u}) {
        if (is_constant(operands[i], true)) return std::move(operands[1 - i]);
        if (is_constant(operands[i], false)) return folded(Formula::Kind::negation, {std::move(operands[1 - i])});
      }
      break;
    case Formula::Kind::constant:
    case Formula::Kind::member:
    case Formula::Kind::equality:
    case Formula::Kind::clock:
    case Formula::Kind::knowledge:
      CHECK(false && "a connective");
  }
  return node(kind, std::move(operands));
}

Formula with_clocks(const Formula& formula, const std::function<const Ticks*(ClockId)>& value_of) {
  if (formula.kind == Formula::Kind::clock) {
    const Ticks* reading = value_of(formula.clock);
    return constant(reading != nullptr && compare(*reading, formula.comparison, formula.bound));
  }
  if (formula.operands.empty() || formula.kind == Formula::Kind::knowledge) return formula;
  std::vector<Formula> operands;
  operands.reserve(formula.operands.size());
  for (const Formula& operand : formula.operands) operands.push_back(with_clocks(operand, value_of));
  return folded(formula.kind, std::move(operands));
}

Formula with_knowledge(const Formula& formula, const std::function<bool(const Formula& atom)>& answer) {
  if (formula.kind == Formula::Kind::knowledge) return constant(answer(formula));
  if (formula.operands.empty()) return formula;
  std::vector<Formula> operands;
  operands.reserve(formula.operands.size());
  for (const Formula& operand : formula.operands) operands.push_back(with_knowledge(operand, answer));
  return folded(formula.kind, std::move(operands));
}

bool has_knowledge(const Formula& formula) {
  return formula.kind == Formula::Kind::knowledge ||
         std::any_of(formula.operands.begin(), formula.operands.end(), has_knowledge);
}

bool is_of_states(const Formula& formula) { return !has_clock(formula) && !has_knowledge(formula); }

void collect_knowledge(const Formula& formula, std::vector<Formula>& atoms) {
  if (formula.kind != Formula::Kind::knowledge) {
    for (const Formula& operand : formula.operands) collect_knowledge(operand, atoms);
  } else if (std::find(atoms.begin(), atoms.end(), formula) == atoms.end()) {
    atoms.push_back(formula);
  }
}

bool has_clock(const Formula& formula) {
  return formula.kind == Formula::Kind::clock ||
         std::any_of(formula.operands.begin(), formula.operands.end(), has_clock);
}

std::vector<VariableId> variables_of(const Formula& formula) {
  std::vector<VariableId> found;
  visit_atoms(formula, [&](const Formula& atom) {
    if (atom.kind == Formula::Kind::member || atom.kind == Formula::Kind::equality) found.push_back(atom.variable);
    if (atom.kind == Formula::Kind::equality) found.push_back(atom.other);
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Formula renamed(const Formula& formula, const std::function<VariableId(VariableId)>& variable,
                const std::function<ValueId(VariableId, ValueId)>& value) {
  Formula result = formula;
  if (formula.kind == Formula::Kind::member) {
    std::vector<ValueId> values;
    for (const ValueId v : formula.values) values.push_back(value(formula.variable, v));
    return member(variable(formula.variable), std::move(values));
  }
  if (formula.kind == Formula::Kind::equality) {
    return equality(variable(formula.variable), variable(formula.other));
  }
  if (formula.kind == Formula::Kind::knowledge && formula.about_one) result.variable = variable(formula.variable);
  for (Formula& operand : result.operands) operand = renamed(operand, variable, value);
  return result;
}

}  // namespace rmpl::automata
