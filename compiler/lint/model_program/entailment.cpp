// Stores that are proposed, and worlds that refute them.
// SPDX-License-Identifier: MIT
#include "compiler/lint/model_program/entailment.hpp"

#include <cstddef>
#include <string>
#include <utility>

namespace rmpl::compiler {

using automata::Assignment;
using automata::Formula;
using automata::ValueId;
using automata::VariableId;

namespace {

constexpr ValueId untold{0}, is_told{1};  // of a selector

std::vector<VariableId> add_selectors(StorePart& part) {
  std::vector<VariableId> selectors;
  for (std::size_t t = 0; t < part.tellable.size(); ++t) {
    selectors.push_back(part.variables.add({"told " + std::to_string(t), {"no", "yes"}}));  // no surface name
  }
  return selectors;
}

void tell(automata::Theory& theory, const StorePart& part, const std::vector<VariableId>& selectors) {
  for (const Formula& standing : part.standing) theory.tell(standing);
  for (std::size_t t = 0; t < selectors.size(); ++t) theory.tell_if({selectors[t], is_told}, part.tellable[t].second);
}

}  // namespace

Entailment::Entailment(StorePart part, Formula formula)
    : part_(std::move(part)),
      selectors_(add_selectors(part_)),
      formula_(std::move(formula)),
      stores_(part_.variables),
      worlds_(part_.variables) {
  tell(stores_, part_, selectors_);
  tell(worlds_, part_, selectors_);
}

bool Entailment::may_fail() { return worlds_.allows({}, worlds_.encode(negation(formula_))); }

bool Entailment::may_hold(const std::vector<bool>& marked) {
  std::vector<Assignment> silent;
  for (std::size_t t = 0; t < selectors_.size(); ++t) {
    if (!marked[part_.tellable[t].first.index()]) silent.push_back({selectors_[t], untold});
  }
  const auto fails = worlds_.encode(negation(formula_));
  constexpr std::size_t most_proposals = 256;
  for (std::size_t proposal = 0; !held_ && proposal < most_proposals; ++proposal) {
    if (!stores_.consistent(silent)) return false;
    std::vector<Assignment> store;
    for (const VariableId selector : selectors_) store.push_back({selector, stores_.value(selector)});
    for (const VariableId free : part_.free) store.push_back({free, stores_.value(free)});
    if (!worlds_.allows(store, fails)) break;
    exclude_world();
  }
  held_ = true;
  return true;
}

/// A store that entails the formula says something that is false in the world that was found.
void Entailment::exclude_world() {
  std::vector<Formula> excluding;
  const auto value_of = [&](VariableId variable) { return worlds_.value(variable); };
  for (std::size_t t = 0; t < part_.tellable.size(); ++t) {
    if (!evaluate(part_.tellable[t].second, value_of)) excluding.push_back(is(selectors_[t], is_told));
  }
  for (const VariableId free : part_.free) excluding.push_back(negation(is(free, worlds_.value(free))));
  stores_.tell(disjunction(std::move(excluding)));
}

}  // namespace rmpl::compiler
