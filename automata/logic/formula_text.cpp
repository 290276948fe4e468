// Constraints in the surface syntax, with no more parentheses than needed.
// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>
#include <string>

#include "automata/logic/formula.hpp"

namespace rmpl::automata {
namespace {

/// How tightly a connective binds; a looser operand is parenthesised.
int strength(const Formula& formula) {
  switch (formula.kind) {
    case Formula::Kind::equivalence:
      return 0;
    case Formula::Kind::implication:
      return 1;
    case Formula::Kind::disjunction:
      return 2;
    case Formula::Kind::conjunction:
      return 3;
    case Formula::Kind::negation:
      return 4;
    case Formula::Kind::constant:
    case Formula::Kind::member:
    case Formula::Kind::equality:
    case Formula::Kind::clock:
    case Formula::Kind::knowledge:
      return 5;
  }
  return 5;
}

const char* spelling(Comparison comparison) {
  switch (comparison) {
    case Comparison::less:
      return " < ";
    case Comparison::at_most:
      return " <= ";
    case Comparison::greater:
      return " > ";
    case Comparison::at_least:
      return " >= ";
  }
  return " ? ";
}

std::string membership(const Formula& formula, const Variables& variables) {
  const Variable& variable = variables[formula.variable];
  if (formula.values.size() == 1) return variable.name + " = " + variable.values[formula.values[0].index()];
  if (variable.values.size() > 2 && formula.values.size() + 1 == variable.values.size()) {
    for (std::size_t v = 0; v < variable.values.size(); ++v) {
      if (v >= formula.values.size() || formula.values[v] != ValueId(v)) {
        return variable.name + " != " + variable.values[v];
      }
    }
  }
  std::string text = variable.name + " in {";
  for (std::size_t i = 0; i < formula.values.size(); ++i) {
    text += (i == 0 ? "" : ", ") + variable.values[formula.values[i].index()];
  }
  return text + "}";
}

std::string decimal(double value) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), written.ptr};
}

const char* word_for(Knowing knowing) {
  switch (knowing) {
    case Knowing::surprise:
      return "surprise";
    case Knowing::no_plan:
      return "noplan";
    case Knowing::possible:
      return "possible";
    case Knowing::likely:
      return "likely";
  }
  return "";
}

}  // namespace

std::string to_text(const Formula& formula, const Variables& variables, std::span<const std::string> clocks) {
  const auto operand = [&](const Formula& f, int at_least) {
    std::string text = to_text(f, variables, clocks);
    return strength(f) < at_least ? "(" + text + ")" : text;
  };
  const auto joined = [&](const char* separator, int at_least) {
    std::string text;
    for (const Formula& f : formula.operands) text += (text.empty() ? "" : separator) + operand(f, at_least);
    return text;
  };
  switch (formula.kind) {
    case Formula::Kind::constant:
      return formula.truth ? "true" : "false";
    case Formula::Kind::member:
      return membership(formula, variables);
    case Formula::Kind::equality:
      return variables.name(formula.variable) + " = " + variables.name(formula.other);
    case Formula::Kind::clock:
      return clocks[formula.clock.index()] + spelling(formula.comparison) + format_seconds(formula.bound) + " s";
    case Formula::Kind::knowledge: {
      std::string text = word_for(formula.knowing);
      if (formula.about_one) return text + "(" + variables.name(formula.variable) + ")";
      if (formula.operands.empty()) return text;
      text += "(" + operand(formula.operands[0], 0);
      const bool usual = formula.knowing == Knowing::possible && formula.probability == least_possible;
      return text + (usual ? "" : ", " + decimal(formula.probability)) + ")";
    }
    case Formula::Kind::negation:
      return "!" + operand(formula.operands[0], 5);
    case Formula::Kind::conjunction:
      return joined(" & ", 4);
    case Formula::Kind::disjunction:
      return joined(" | ", 3);
    case Formula::Kind::implication:
      return operand(formula.operands[0], 2) + " -> " + operand(formula.operands[1], 1);
    case Formula::Kind::equivalence:
      return operand(formula.operands[0], 1) + " <-> " + operand(formula.operands[1], 1);
  }
  return {};
}

}  // namespace rmpl::automata
