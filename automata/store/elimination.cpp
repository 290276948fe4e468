// Elimination of attributes.
// SPDX-License-Identifier: MIT
#include "automata/store/elimination.hpp"

#include <algorithm>

#include "automata/logic/theory.hpp"
#include "automata/store/value_set.hpp"

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
    told_.push_back({whole, variables_of(whole), constraint.under});
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

/// Where constraints are told under the values of one variable, as those of modes are, these are cases: in each but a
/// few of the constraints say something.
bool Elimination::always_has_a_value(VariableId attribute) const {
  const std::set<std::size_t>& constraints = readers_.at(attribute);
  const auto under = mostly_under(constraints);
  const Division division = divide(constraints, under);
  if (!under) return always_left(case_of(division, attribute, std::nullopt), attribute);
  for (std::size_t v = 0; v < values_of(*under); ++v) {
    if (!always_left(case_of(division, attribute, Assignment{*under, ValueId(v)}), attribute)) return false;
  }
  return true;
}

Elimination::Division Elimination::divide(const std::set<std::size_t>& constraints,
                                          std::optional<VariableId> under) const {
  Division result;
  for (const std::size_t t : constraints) {
    const auto& own = told_[t].under;
    (own && own->variable == under ? result.under[own->value] : result.always).push_back(t);
  }
  return result;
}

std::optional<VariableId> Elimination::mostly_under(const std::set<std::size_t>& constraints) const {
  std::map<VariableId, std::size_t> count;
  for (const std::size_t t : constraints) {
    if (told_[t].under) ++count[told_[t].under->variable];
  }
  const auto most =
      std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == count.end() || most->second < 2 ? std::nullopt : std::optional(most->first);
}

Elimination::Case Elimination::case_of(const Division& constraints, VariableId attribute,
                                       std::optional<Assignment> given) const {
  Case result;
  const auto add = [&](const std::vector<std::size_t>& positions) {
    for (const std::size_t t : positions) {
      const Told& told = told_[t];
      result.others.insert(result.others.end(), told.variables.begin(), told.variables.end());
      result.formulas.push_back(given ? fixed(told.formula, given->variable, given->value) : told.formula);
    }
  };
  add(constraints.always);
  if (given) {
    if (const auto own = constraints.under.find(given->value); own != constraints.under.end()) add(own->second);
  }
  std::sort(result.others.begin(), result.others.end());
  result.others.erase(std::unique(result.others.begin(), result.others.end()), result.others.end());
  std::erase_if(result.others, [&](VariableId v) { return v == attribute || (given && v == given->variable); });
  return result;
}

Elimination::Contradicted Elimination::contradicted(const Case& given, VariableId attribute) const {
  const Formula all = conjunction(given.formulas);
  Contradicted result;
  for (std::size_t v = 0; v < values_of(attribute); ++v) {
    result.push_back(negation(fixed(all, attribute, ValueId(v))));
  }
  return result;
}

bool Elimination::always_left(const Case& given, VariableId attribute) const {
  if (combinations_of(given.others) > most_combinations) return !solvable(contradicted(given, attribute), given.others);
  return !any_combination(given.others, [&](const auto& value_of) {
    return values_left(given.formulas, attribute, value_of).size(values_of(attribute)) == 0;
  });
}

std::vector<std::vector<bool>> Elimination::leaves_another(VariableId attribute, VariableId given) const {
  const Division division = divide(gone_.at(attribute), given);
  std::vector<std::vector<bool>> result;
  for (std::size_t v = 0; v < values_of(given); ++v) {
    result.push_back(leaves_another(case_of(division, attribute, Assignment{given, ValueId(v)}), attribute));
  }
  return result;
}

std::vector<bool> Elimination::leaves_another(const Case& given, VariableId attribute) const {
  std::vector<bool> result(values_of(attribute), true);
  if (combinations_of(given.others) > most_combinations) {
    const Contradicted excludes = contradicted(given, attribute);
    for (std::size_t v = 0; v < excludes.size(); ++v) {
      Contradicted others = excludes;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(v));
      result[v] = !solvable(std::move(others), given.others);
    }
    return result;
  }
  // Another one than this is missed where this is the only one that is left, or none is.
  any_combination(given.others, [&](const auto& value_of) {
    const ValueSet left = values_left(given.formulas, attribute, value_of);
    const std::size_t count = left.size(result.size());
    if (count == 0) result.assign(result.size(), false);
    if (count == 1) result[left.first()->index()] = false;
    return count == 0;
  });
  return result;
}

std::size_t Elimination::combinations_of(const std::vector<VariableId>& variables) const {
  std::size_t combinations = 1;
  for (const VariableId v : variables) combinations = std::min(combinations * values_of(v), most_combinations + 1);
  return combinations;
}

/// Visits assignments of values to the variables, ascending, as functions; up to the first for which `visit` is true.
template <class Visit>
bool Elimination::any_combination(const std::vector<VariableId>& variables, const Visit& visit) const {
  std::vector<ValueId> values(variables.size(), ValueId(0));
  const auto value_of = [&](VariableId variable) {
    return values[static_cast<std::size_t>(std::lower_bound(variables.begin(), variables.end(), variable) -
                                           variables.begin())];
  };
  const std::size_t combinations = combinations_of(variables);
  for (std::size_t i = 0; i < combinations; ++i) {
    if (visit(value_of)) return true;
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = ValueId(values[k].index() + 1);
      if (values[k].index() < values_of(variables[k])) break;
      values[k] = ValueId(0);
    }
  }
  return false;
}

/// Whether some values of the variables make all of these true; they read no others. Asks a solver.
bool Elimination::solvable(Contradicted parts, const std::vector<VariableId>& variables) const {
  const auto position = [&](VariableId variable) {
    return static_cast<std::size_t>(std::lower_bound(variables.begin(), variables.end(), variable) - variables.begin());
  };
  Variables own;
  for (const VariableId v : variables) own.add(variables_[v]);
  Theory theory(own);
  const auto handle = theory.encode(renamed(
      conjunction(std::move(parts)), [&](VariableId v) { return VariableId(position(v)); },
      [](VariableId, ValueId v) { return v; }));
  return theory.allows({}, handle);
}

}  // namespace rmpl::automata
