// Elimination of attributes.
// SPDX-License-Identifier: MIT
#include "automata/store/elimination.hpp"

#include <algorithm>

#include "automata/logic/theory.hpp"

namespace rmpl::automata {
namespace {

/// So many combinations of values are tried one by one; beyond that a solver is asked.
constexpr std::size_t most_combinations = 1u << 10;

/// The formula with a variable fixed.
Formula fixed(const Formula& formula, VariableId variable, ValueId value) {
  switch (formula.kind) {
    case Formula::Kind::member:
      if (formula.variable != variable) return formula;
      return constant(std::binary_search(formula.values.begin(), formula.values.end(), value));
    case Formula::Kind::equality:
      if (formula.variable == variable && formula.other == variable) return constant(true);
      if (formula.variable == variable) return is(formula.other, value);
      if (formula.other == variable) return is(formula.variable, value);
      return formula;
    default: {
      Formula result = formula;
      for (Formula& operand : result.operands) operand = fixed(operand, variable, value);
      return result;
    }
  }
}

}  // namespace

Elimination::Elimination(const Variables& variables, const std::vector<Constraint>& constraints,
                         const std::vector<VariableId>& attributes)
    : variables_(variables) {
  for (const VariableId attribute : attributes) readers_.try_emplace(attribute);
  for (const Constraint& constraint : constraints) {
    const std::size_t t = told_.size();
    const Formula whole = constraint.under
                              ? implication(is(constraint.under->variable, constraint.under->value), constraint.formula)
                              : constraint.formula;
    told_.push_back({whole, variables_of(whole)});
    left_.insert(t);
    for (const VariableId v : told_[t].variables) {
      if (const auto at = readers_.find(v); at != readers_.end()) at->second.insert(t);
    }
  }
  for (const auto& [attribute, readers] : readers_) open_.emplace(readers.size(), attribute);
  // What few constraints read is quick to judge, and effects are read by few. What cannot go is looked at again when
  // something that reads it has gone.
  while (!open_.empty()) {
    const VariableId attribute = open_.begin()->second;
    open_.erase(open_.begin());
    if (!always_has_a_value(attribute)) continue;
    const std::set<std::size_t>& readers = gone_[attribute] = std::move(readers_.at(attribute));
    readers_.erase(attribute);
    for (const std::size_t t : readers) take_away(t);
  }
}

void Elimination::take_away(std::size_t constraint) {
  left_.erase(constraint);
  for (const VariableId v : told_[constraint].variables) {
    const auto at = readers_.find(v);
    if (at == readers_.end()) continue;
    open_.erase({at->second.size(), v});
    at->second.erase(constraint);
    open_.emplace(at->second.size(), v);
  }
}

bool Elimination::always_has_a_value(VariableId attribute) const {
  return always_left(readers_.at(attribute), attribute, std::nullopt, std::nullopt);
}

bool Elimination::leaves_another(Assignment value, Assignment given) const {
  return always_left(gone_.at(value.variable), value.variable, value.value, given);
}

bool Elimination::always_left(const std::set<std::size_t>& constraints, VariableId attribute,
                              std::optional<ValueId> but, std::optional<Assignment> given) const {
  std::vector<VariableId> others;
  std::vector<Formula> all;
  for (const std::size_t t : constraints) {
    others.insert(others.end(), told_[t].variables.begin(), told_[t].variables.end());
    all.push_back(given ? fixed(told_[t].formula, given->variable, given->value) : told_[t].formula);
  }
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  std::erase_if(others, [&](VariableId v) { return v == attribute || (given && v == given->variable); });
  std::vector<Formula> contradicted;
  for (std::size_t v = 0; v < values_of(attribute); ++v) {
    if (ValueId(v) != but) contradicted.push_back(negation(fixed(conjunction(all), attribute, ValueId(v))));
  }
  return !satisfiable(conjunction(std::move(contradicted)), others);
}

/// Whether some values of the variables make the formula true; it reads no others.
bool Elimination::satisfiable(const Formula& formula, const std::vector<VariableId>& variables) const {
  const auto position = [&](VariableId variable) {
    return static_cast<std::size_t>(std::lower_bound(variables.begin(), variables.end(), variable) - variables.begin());
  };
  std::size_t combinations = 1;
  for (const VariableId v : variables) combinations = std::min(combinations * values_of(v), most_combinations + 1);
  if (combinations > most_combinations) {
    Variables own;
    for (const VariableId v : variables) own.add(variables_[v]);
    Theory theory(own);
    const auto handle = theory.encode(renamed(
        formula, [&](VariableId v) { return VariableId(position(v)); }, [](VariableId, ValueId v) { return v; }));
    return theory.allows({}, handle);
  }
  std::vector<ValueId> values(variables.size(), ValueId(0));
  for (std::size_t i = 0; i < combinations; ++i) {
    if (evaluate(formula, [&](VariableId v) { return values[position(v)]; })) return true;
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = ValueId(values[k].index() + 1);
      if (values[k].index() < values_of(variables[k])) break;
      values[k] = ValueId(0);
    }
  }
  return false;
}

}  // namespace rmpl::automata
