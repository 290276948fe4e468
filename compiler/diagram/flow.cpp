// Reading and being read, by the form of constraints.
// SPDX-License-Identifier: MIT
#include "compiler/diagram/flow.hpp"

#include <algorithm>

namespace rmpl::compiler {
namespace {

using automata::Formula;
using automata::VariableId;

void mark_all(const Formula& formula, std::vector<bool>& read) {
  for (const VariableId variable : automata::variables_of(formula)) read[variable.index()] = true;
}

/// Marks what the constraint of a mode depends on: right sides of equalities and `<->`, premises.
void mark_read(const Formula& constraint, std::vector<bool>& read) {
  switch (constraint.kind) {
    case Formula::Kind::equality:
      read[constraint.other.index()] = true;
      return;
    case Formula::Kind::implication:
      mark_all(constraint.operands[0], read);
      return mark_read(constraint.operands[1], read);
    case Formula::Kind::equivalence:
      mark_all(constraint.operands[1], read);
      return mark_read(constraint.operands[0], read);
    case Formula::Kind::conjunction:
    case Formula::Kind::disjunction:
      for (const Formula& operand : constraint.operands) mark_read(operand, read);
      return;
    case Formula::Kind::constant:
    case Formula::Kind::member:
    case Formula::Kind::clock:
    case Formula::Kind::knowledge:
    case Formula::Kind::negation:
      return;
  }
}

/// The variables in the order in which they are written, each once.
void collect(const Formula& formula, std::vector<VariableId>& variables) {
  const auto add = [&](VariableId variable) {
    if (std::find(variables.begin(), variables.end(), variable) == variables.end()) variables.push_back(variable);
  };
  if (formula.kind == Formula::Kind::member || formula.kind == Formula::Kind::equality) add(formula.variable);
  if (formula.kind == Formula::Kind::equality) add(formula.other);
  for (const Formula& operand : formula.operands) collect(operand, variables);
}

}  // namespace

std::vector<bool> read_variables(const automata::Plant& plant) {
  std::vector<bool> read(plant.variables.size(), false);
  for (const automata::Component& component : plant.components) {
    for (const automata::Transition& transition : component.transitions) mark_all(transition.guard, read);
    for (const automata::Mode& mode : component.modes) mark_read(mode.constraint, read);
  }
  return read;
}

Flow flow_of(const Formula& constraint, const std::vector<bool>& read) {
  std::vector<VariableId> variables;
  collect(constraint, variables);
  Flow flow;
  for (const VariableId variable : variables) (read[variable.index()] ? flow.to : flow.from).push_back(variable);
  if (variables.size() < 2 || (!flow.from.empty() && !flow.to.empty())) return flow;
  const bool defines =
      constraint.kind == Formula::Kind::equivalence && automata::variables_of(constraint.operands[0]).size() == 1;
  flow.from.assign(variables.begin(), variables.begin() + 1);
  flow.to.assign(variables.begin() + 1, variables.end());
  if (defines) std::swap(flow.from, flow.to);
  return flow;
}

}  // namespace rmpl::compiler
