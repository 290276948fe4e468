// Conditions in the notation of C.
// SPDX-License-Identifier: MIT
#include "verifier/export/condition_text.hpp"

#include <cctype>
#include <vector>

#include "base/check.hpp"

namespace rmpl::verifier {

using automata::Formula;
using automata::ValueId;

namespace {

/// How strongly the last connective of a text binds.
enum class Binding { either, both, atom };

struct Text {
  std::string text;
  Binding binding;

  [[nodiscard]] std::string within(Binding outer) const { return binding < outer ? "(" + text + ")" : text; }
};

Text member_text(const Formula& formula, const automata::Plant& plant, const NameOf& name_of) {
  const std::string name = name_of(formula.variable);
  const std::vector<ValueId>& values = formula.values;
  const std::size_t all = plant.variables[formula.variable].values.size();
  const auto number = [](std::size_t value) { return std::to_string(value); };
  if (values.size() == 1) return {name + " == " + number(values.front().index()), Binding::atom};
  const std::size_t first = values.front().index();
  const std::size_t last = values.back().index();
  if (last - first + 1 == values.size()) {
    if (first == 0 && last + 1 == all) return {"true", Binding::atom};
    if (first == 0) return {name + " <= " + number(last), Binding::atom};
    if (last + 1 == all) return {name + " >= " + number(first), Binding::atom};
    return {name + " >= " + number(first) + " && " + name + " <= " + number(last), Binding::both};
  }
  if (values.size() + 1 == all) {
    std::size_t missing = 0;
    while (values[missing].index() == missing) ++missing;
    return {name + " != " + number(missing), Binding::atom};
  }
  std::string text;
  for (const ValueId value : values) text += (text.empty() ? "" : " || ") + name + " == " + number(value.index());
  return {text, Binding::either};
}

Text text_of(const Formula& formula, const automata::Plant& plant, const NameOf& name_of) {
  switch (formula.kind) {
    case Formula::Kind::constant:
      return {formula.truth ? "true" : "false", Binding::atom};
    case Formula::Kind::member:
      return member_text(formula, plant, name_of);
    case Formula::Kind::negation:
      return {"!(" + text_of(formula.operands.front(), plant, name_of).text + ")", Binding::atom};
    case Formula::Kind::conjunction:
    case Formula::Kind::disjunction: {
      const bool both = formula.kind == Formula::Kind::conjunction;
      const Binding binding = both ? Binding::both : Binding::either;
      std::string text;
      for (const Formula& operand : formula.operands) {
        text += (text.empty() ? "" : both ? " && " : " || ") + text_of(operand, plant, name_of).within(binding);
      }
      return {text, binding};
    }
    default:
      break;
  }
  CHECK(false && "a condition is made of members");
  return {};
}

}  // namespace

std::string condition_text(const Formula& formula, const automata::Plant& plant, const NameOf& name_of) {
  return text_of(formula, plant, name_of).text;
}

std::string identifier(const std::string& name) {
  std::string text;
  for (const char c : name) text += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  const bool letter = !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0;
  return letter ? text : "n" + text;
}

}  // namespace rmpl::verifier
