// The part of a model program that a condition is about, and what is told together.
// SPDX-License-Identifier: MIT
#include "compiler/lint/model_program/told_stores.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace rmpl::compiler {

using automata::Assignment;
using automata::Formula;
using automata::LocationId;
using automata::ModelProgram;
using automata::ValueId;
using automata::VariableId;

namespace {

constexpr ValueId told_here{1};  // of a selector

bool tells(const automata::ModelLocation& location) { return !location.composite && !location.told.is_true(); }

std::vector<VariableId> free_variables(const ModelProgram& program) {
  std::vector<VariableId> free;
  if (program.controls.empty() && program.observables.empty()) {
    for (std::size_t v = 0; v < program.variables.size(); ++v) free.emplace_back(v);
  }
  for (const automata::CommandedVariable& control : program.controls) free.push_back(control.variable);
  return free;
}

automata::Variables with_selectors(const ModelProgram& program, std::vector<std::optional<VariableId>>& told,
                                   std::vector<Assignment>& standing) {
  automata::Variables variables = program.variables;
  const auto add = [&](std::string name) {
    return variables.add({std::move(name), {"no", "yes"}});
  };  // no surface name
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    auto& selector = told.emplace_back();
    if (tells(program.locations[l])) selector = add("location " + std::to_string(l + 1));
  }
  for (std::size_t c = 0; c < program.constraints.size(); ++c) {
    standing.push_back({add("constraint " + std::to_string(c + 1)), told_here});
  }
  return variables;
}

}  // namespace

ToldStores::ToldStores(const ModelProgram& program)
    : program_(program),
      free_(free_variables(program)),
      spoken_of_(program.variables.size(), false),
      parts_(program.variables.size()),
      together_(with_selectors(program, selectors_, standing_), automata::Theory::Upkeep::maintained) {
  const auto join = [&](const Formula& formula) {
    const std::vector<VariableId> variables = variables_of(formula);
    for (const VariableId v : variables) {
      parts_.join(v.index(), variables.front().index());
      spoken_of_[v.index()] = true;
    }
  };
  for (const VariableId v : free_) spoken_of_[v.index()] = true;
  for (std::size_t c = 0; c < standing_.size(); ++c) {
    join(program.constraints[c].constraint);
    together_.tell_if(standing_[c], program.constraints[c].constraint);
  }
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    if (!selectors_[l]) continue;
    join(program.locations[l].told);
    together_.tell_if({*selectors_[l], told_here}, program.locations[l].told);
  }
  list_members();
}

void ToldStores::list_members() {
  const auto members_of = [&](const Formula& formula) -> Members* {
    const auto variables = variables_of(formula);
    return variables.empty() ? nullptr : &members_[parts_.root(variables.front().index())];
  };
  for (std::size_t v = 0; v < program_.variables.size(); ++v) members_[parts_.root(v)].variables.emplace_back(v);
  for (const VariableId v : free_) members_[parts_.root(v.index())].free.push_back(v);
  for (std::size_t c = 0; c < standing_.size(); ++c) {
    if (Members* const part = members_of(program_.constraints[c].constraint)) part->standing.push_back(c);
  }
  for (std::size_t l = 0; l < selectors_.size(); ++l) {
    if (!selectors_[l]) continue;
    if (Members* const part = members_of(program_.locations[l].told)) part->told.emplace_back(l);
  }
}

bool ToldStores::is_spoken_of(VariableId variable) { return spoken_of_[variable.index()]; }

std::optional<ToldContradiction> ToldStores::contradiction() { return contradiction_in(standing_); }

std::optional<ToldContradiction> ToldStores::contradiction(const std::vector<LocationId>& together) {
  std::set<std::size_t> beside;  // what stands over other variables has no part in it
  std::vector<Assignment> told;
  for (const LocationId l : together) {
    if (!selectors_[l.index()]) continue;
    told.push_back({*selectors_[l.index()], told_here});
    for (const VariableId v : variables_of(program_.locations[l.index()].told)) {
      const auto& standing = members_[parts_.root(v.index())].standing;
      beside.insert(standing.begin(), standing.end());
    }
  }
  for (const std::size_t c : beside) told.push_back(standing_[c]);
  return contradiction_in(told);
}

std::optional<ToldContradiction> ToldStores::contradiction_in(const std::vector<Assignment>& selected) {
  if (together_.consistent(selected)) return std::nullopt;
  ToldContradiction blamed;
  for (const Assignment& one : together_.minimal_conflict(together_.conflict())) {
    const auto standing = std::find(standing_.begin(), standing_.end(), one);
    if (standing != standing_.end()) {
      blamed.standing.push_back(static_cast<std::size_t>(standing - standing_.begin()));
      continue;
    }
    const auto at = std::find(selectors_.begin(), selectors_.end(), std::optional(one.variable));
    blamed.told.emplace_back(static_cast<std::size_t>(at - selectors_.begin()));
  }
  std::sort(blamed.told.begin(), blamed.told.end());
  return blamed;
}

/// The part of the program whose variables have to do with those of the formula, in tables of its own.
Entailment& ToldStores::entailment_of(const Formula& formula) {
  auto& known = entailments_[to_text(formula, program_.variables)];
  if (known) return *known;
  std::set<std::size_t> roots;
  for (const VariableId v : variables_of(formula)) roots.insert(parts_.root(v.index()));
  StorePart part;
  std::map<VariableId, VariableId> renaming;
  const auto rename = [&](const Formula& one) {
    return renamed(
        one, [&](VariableId v) { return renaming.at(v); }, [](VariableId, ValueId value) { return value; });
  };
  for (const std::size_t root : roots) {
    const Members& members = members_[root];
    for (const VariableId v : members.variables) renaming[v] = part.variables.add(program_.variables[v]);
    for (const VariableId v : members.free) part.free.push_back(renaming[v]);
    for (const std::size_t c : members.standing) part.standing.push_back(rename(program_.constraints[c].constraint));
    for (const LocationId l : members.told) part.tellable.emplace_back(l, rename(program_.locations[l.index()].told));
  }
  known = std::make_unique<Entailment>(std::move(part), rename(formula));
  return *known;
}

Freedom ToldStores::freedom(const automata::Condition& condition, const std::vector<bool>& marked) {
  if (condition.is_trivial()) return {true, false};
  if (condition.constraint.kind == Formula::Kind::constant) {
    const bool holds = condition.constraint.truth == condition.entailed;
    return {holds, !holds};
  }
  Entailment& entailment = entailment_of(condition.constraint);
  Freedom free{entailment.may_hold(marked), entailment.may_fail()};
  if (!condition.entailed) std::swap(free.may_hold, free.may_fail);
  return free;
}

}  // namespace rmpl::compiler
