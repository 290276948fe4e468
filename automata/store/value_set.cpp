// Sets of values.
// SPDX-License-Identifier: MIT
#include "automata/store/value_set.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/check.hpp"

namespace rmpl::automata {
namespace {

using ValueOf = base::FunctionRef<ValueId(VariableId)>;

ValueSet allowed(const Formula& formula, VariableId variable, ValueOf value_of) {
  const auto whether = [](bool holds) { return holds ? ValueSet::all() : ValueSet::none(); };
  const auto operand = [&](std::size_t i) { return allowed(formula.operands[i], variable, value_of); };
  switch (formula.kind) {
    case Formula::Kind::constant:
      return whether(formula.truth);
    case Formula::Kind::member:
      if (formula.variable == variable) return ValueSet::of(formula.values);
      return whether(std::binary_search(formula.values.begin(), formula.values.end(), value_of(formula.variable)));
    case Formula::Kind::equality: {
      if (formula.variable == formula.other) return ValueSet::all();
      if (formula.variable == variable) return ValueSet::of({value_of(formula.other)});
      if (formula.other == variable) return ValueSet::of({value_of(formula.variable)});
      return whether(value_of(formula.variable) == value_of(formula.other));
    }
    case Formula::Kind::negation:
      return operand(0).complement();
    case Formula::Kind::conjunction: {
      ValueSet result = ValueSet::all();
      for (std::size_t i = 0; i < formula.operands.size(); ++i) result = result & operand(i);
      return result;
    }
    case Formula::Kind::disjunction: {
      ValueSet result = ValueSet::none();
      for (std::size_t i = 0; i < formula.operands.size(); ++i) result = result | operand(i);
      return result;
    }
    case Formula::Kind::implication:
      return operand(0).complement() | operand(1);
    case Formula::Kind::equivalence: {
      const ValueSet one = operand(0), other = operand(1);
      return (one & other) | (one.complement() & other.complement());
    }
    case Formula::Kind::clock:
    case Formula::Kind::knowledge:
      break;
  }
  CHECK(false && "a constraint over values");
  return ValueSet::all();
}

}  // namespace

ValueSet ValueSet::operator&(const ValueSet& other) const {
  std::vector<ValueId> values;
  const auto into = std::back_inserter(values);
  const auto &one = values_, &two = other.values_;
  if (!excepted_ && !other.excepted_) {
    std::set_intersection(one.begin(), one.end(), two.begin(), two.end(), into);
  } else if (!excepted_) {
    std::set_difference(one.begin(), one.end(), two.begin(), two.end(), into);
  } else if (!other.excepted_) {
    std::set_difference(two.begin(), two.end(), one.begin(), one.end(), into);
  } else {
    std::set_union(one.begin(), one.end(), two.begin(), two.end(), into);
  }
  return {excepted_ && other.excepted_, std::move(values)};
}

std::optional<ValueId> ValueSet::first() const {
  if (!excepted_) return values_.empty() ? std::nullopt : std::optional(values_.front());
  std::size_t least = 0;
  while (least < values_.size() && values_[least].index() == least) ++least;
  return ValueId(least);
}

ValueSet values_left(std::span<const Formula> formulas, VariableId variable, ValueOf value_of) {
  ValueSet result = ValueSet::all();
  for (const Formula& formula : formulas) result = result & allowed(formula, variable, value_of);
  return result;
}

}  // namespace rmpl::automata
