// Variables replaced by their values.
// SPDX-License-Identifier: MIT
#include "automata/logic/given.hpp"

#include <algorithm>
#include <optional>

namespace rmpl::automata {

Formula with_values(const Formula& formula, std::span<const Assignment> given) {
  const auto value_of = [&](VariableId variable) {
    const auto at =
        std::find_if(given.begin(), given.end(), [&](const Assignment& a) { return a.variable == variable; });
    return at == given.end() ? std::nullopt : std::optional(at->value);
  };
  if (formula.kind == Formula::Kind::member) {
    const auto value = value_of(formula.variable);
    if (!value) return formula;
    return constant(std::binary_search(formula.values.begin(), formula.values.end(), *value));
  }
  if (formula.kind == Formula::Kind::equality) {
    const auto one = value_of(formula.variable);
    const auto other = value_of(formula.other);
    if (one && other) return constant(*one == *other);
    if (one) return is(formula.other, *one);
    if (other) return is(formula.variable, *other);
    return formula;
  }
  Formula result = formula;
  for (Formula& operand : result.operands) operand = with_values(operand, given);
  return result;
}

}  // namespace rmpl::automata
