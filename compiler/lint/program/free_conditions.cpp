// Truths of conditions, by the solver.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/free_conditions.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "base/product.hpp"

#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::VariableId;

FreeConditions::FreeConditions(const automata::Program& program, const automata::Plant* plant,
                               std::vector<Formula> stages)
    : variables_(program.variables),
      visible_(program.variables.size(), plant == nullptr),
      possibilities_(program.variables, plant),
      stages_(std::move(stages)) {
  if (stages_.empty()) stages_.push_back(automata::constant(true));
  if (plant == nullptr) return;
  for (const automata::Component& component : plant->components) visible_[component.mode.index()] = true;
  for (const VariableId observable : plant->observables) visible_[observable.index()] = true;
}

std::optional<std::size_t> FreeConditions::question(const Formula& formula) {
  if (formula.kind == Formula::Kind::constant) return std::nullopt;
  std::string text = to_text(formula, variables_);
  const auto [known, fresh] = by_text_.emplace(text, questions_.size());
  if (fresh) {
    const auto variables = variables_of(formula);
    const bool visible =
        std::all_of(variables.begin(), variables.end(), [&](VariableId v) { return visible_[v.index()]; });
    questions_.push_back({formula, std::move(text), visible});
  }
  return known->second;
}

bool FreeConditions::holds(const Formula& formula, const Truths& truths) {
  const auto asked = question(formula);
  return asked ? truths.at(*asked) : formula.truth;
}

void FreeConditions::for_each(const std::vector<std::size_t>& questions, const Truths& given, std::size_t stage,
                              const std::function<bool(const Truths&)>& visit) {
  Truths truths = given;
  std::vector<std::size_t> open;
  for (std::set<std::size_t> asked; const std::size_t question : questions) {
    if (!given.contains(question) && asked.insert(question).second) open.push_back(question);
  }
  const std::vector<std::array<bool, 2>> answers(open.size(), {true, false});
  base::multiply_out(
      answers,
      [&](std::size_t q, std::size_t a) {
        truths[open[q]] = answers[q][a];
        const bool together = possible(truths, stage);
        if (!together) truths.erase(open[q]);
        return together;
      },
      [&](std::size_t q, std::size_t) { truths.erase(open[q]); }, [&] { return !visit(truths); });
}

bool FreeConditions::possible(const Truths& truths, std::size_t stage) {
  const auto [known, fresh] = known_.emplace(std::pair(stage, truths), true);
  if (!fresh) return known->second;
  std::vector<Formula> together{stages_[stage]};
  for (const auto& [number, truth] : truths) {
    const Question& question = questions_[number];
    // What is hidden may be unknown, so that it is entailed no more than its negation.
    if (truth) {
      together.push_back(question.formula);
    } else if (question.visible) {
      together.push_back(negation(question.formula));
    } else if (!possibilities_.can_hold(automata::conjunction({stages_[stage], negation(question.formula)}))) {
      return known->second = false;
    }
  }
  return known->second = possibilities_.can_hold(conjunction(std::move(together)));
}

std::string FreeConditions::text(const Truths& truths) const {
  std::string text;
  for (const bool truth : {true, false}) {
    for (const auto& [number, value] : truths) {
      if (value != truth) continue;
      text += (text.empty() ? "" : ", ") + std::string(truth ? "" : "not ") + backquoted(questions_[number].text);
    }
  }
  return text;
}

}  // namespace rmpl::compiler
