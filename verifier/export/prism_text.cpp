// SPDX-License-Identifier: MIT
#include "verifier/export/prism_text.hpp"

#include <array>
#include <charconv>

#include "base/check.hpp"

namespace rmpl::verifier::prism {

std::string number(double value) {
  std::array<char, 40> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

Text member_text(const std::string& name, const std::vector<std::size_t>& values, std::size_t all, bool listed) {
  if (values.size() == 1) return {name + "=" + std::to_string(values.front())};
  if (!listed && values.size() + 1 == all) {
    std::size_t missing = 0;
    while (missing < values.size() && values[missing] == missing) ++missing;
    return {name + "!=" + std::to_string(missing)};
  }
  if (values.back() - values.front() + 1 == values.size()) {
    if (values.front() == 0 && !listed) return {name + "<=" + std::to_string(values.back())};
    if (values.back() + 1 == all) return {name + ">=" + std::to_string(values.front())};
  }
  std::string text;
  for (const std::size_t value : values) text += (text.empty() ? "" : " | ") + name + "=" + std::to_string(value);
  return {text, true};
}

Text text_of(const automata::Formula& formula, const automata::Plant& plant, const Naming& naming) {
  switch (formula.kind) {
    case automata::Formula::Kind::constant:
      return {formula.truth ? "true" : "false"};
    case automata::Formula::Kind::member: {
      std::vector<std::size_t> values;
      for (const automata::ValueId value : formula.values) values.push_back(value.index());
      return member_text(naming.mode(*plant.component_of(formula.variable)), values,
                         plant.variables[formula.variable].values.size(), false);
    }
    case automata::Formula::Kind::conjunction:
    case automata::Formula::Kind::disjunction: {
      const bool both = formula.kind == automata::Formula::Kind::conjunction;
      std::string text;
      for (const automata::Formula& operand : formula.operands) {
        const Text part = text_of(operand, plant, naming);
        text += (text.empty() ? "" : both ? " & " : " | ") + (both ? part.operand() : part.text);
      }
      return {text, !both};
    }
    default:
      break;
  }
  CHECK(false && "a table becomes conjunctions and disjunctions");
  return {};
}

void conjoin(std::string& all, const std::string& part) {
  if (!part.empty()) all += (all.empty() ? "" : " & ") + part;
}

}  // namespace rmpl::verifier::prism
