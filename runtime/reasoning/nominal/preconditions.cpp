// Preconditions of transitions, by what decides their guards.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/nominal/preconditions.hpp"

#include <utility>

#include "automata/store/model.hpp"
#include "runtime/reasoning/nominal/precondition_finder.hpp"

namespace rmpl::runtime {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::Constraint;
using automata::Formula;
using automata::ModeId;
using automata::Plant;
using automata::TransitionId;
using automata::ValueId;
using automata::VariableId;

namespace {

/// Writes a formula as words, variables by their numbers in a part. Each kind says how much follows, so that no two
/// formulas are written alike.
void write(std::vector<std::uint64_t>& words, const Formula& formula, const std::vector<std::uint32_t>& number) {
  words.push_back(static_cast<std::uint64_t>(formula.kind) << 1 | (formula.truth ? 1 : 0));
  switch (formula.kind) {
    case Formula::Kind::constant:
    case Formula::Kind::clock:
    case Formula::Kind::knowledge:
      return;
    case Formula::Kind::member:
      words.push_back(std::uint64_t{number[formula.variable.index()]} << 32 | formula.values.size());
      for (const ValueId v : formula.values) words.push_back(v.value);
      return;
    case Formula::Kind::equality:
      words.push_back(std::uint64_t{number[formula.variable.index()]} << 32 | number[formula.other.index()]);
      return;
    case Formula::Kind::negation:
    case Formula::Kind::conjunction:
    case Formula::Kind::disjunction:
    case Formula::Kind::implication:
    case Formula::Kind::equivalence:
      words.push_back(formula.operands.size());
      for (const Formula& operand : formula.operands) write(words, operand, number);
      return;
  }
}

}  // namespace

Preconditions::Preconditions(const Plant& plant)
    : plant_(plant),
      index_(plant),
      relevance_(plant),
      has_states_(!relevance_.excludes() || automata::model_theory(plant).consistent({})),
      number_(plant.variables.size()) {}

VariableId Preconditions::local(VariableId variable) const { return VariableId(number_[variable.index()]); }

Assignment Preconditions::local(const Assignment& assignment) const {
  return {local(assignment.variable), assignment.value};
}

Formula Preconditions::local(const Formula& formula) const {
  return renamed(
      formula, [&](VariableId v) { return local(v); }, [](VariableId, ValueId value) { return value; });
}

/// A question about a part, given one of its modes. Numbers its variables.
Preconditions::Key Preconditions::question_about(const automata::Relevance::Part& part, Assignment mode) {
  for (std::uint32_t i = 0; i < part.variables.size(); ++i) number_[part.variables[i].index()] = i;
  Key question = key(part);
  question.push_back(std::uint64_t{local(mode).variable.value} << 32 | mode.value.value);
  return question;
}

/// What makes a difference to an answer: the variables' domains, which are modes, and which controls with what idle
/// values, and the constraints. Names and weights do not.
Preconditions::Key Preconditions::key(const automata::Relevance::Part& part) const {
  Key key{part.variables.size(), part.constraints.size()};
  for (const VariableId v : part.variables) {
    key.push_back(plant_.variables[v].values.size());
    const auto control = index_.control_of(v);
    key.push_back(index_.component_of(v) ? 1 : control ? 2 + plant_.controls[*control].idle.value : 0);
  }
  for (const std::size_t position : part.constraints) {
    const Constraint& constraint = relevance_.constraints()[position];
    key.push_back(constraint.under ? 1 + number_[constraint.under->variable.index()] : 0);
    key.push_back(constraint.under ? constraint.under->value.value : 0);
    write(key, constraint.formula, number_);
  }
  return key;
}

/// The part as a plant of its own; variables stand as `number_` says. It has no transitions.
Plant Preconditions::plant_of(const automata::Relevance::Part& part) const {
  Plant own;
  std::vector<std::vector<std::vector<Formula>>> told;  // per component, per mode
  std::vector<std::size_t> component_of(part.variables.size());
  for (const VariableId v : part.variables) {
    const VariableId as = own.variables.add(plant_.variables[v]);
    if (const auto c = index_.component_of(v)) {
      component_of[as.index()] = own.components.size();
      Component& component = own.components.emplace_back();
      component.name = plant_[*c].name;
      component.mode = as;
      for (const automata::Mode& mode : plant_[*c].modes) component.modes.push_back({.name = mode.name, .origin = {}});
      told.emplace_back(component.modes.size());
    } else if (const auto i = index_.control_of(v)) {
      own.controls.push_back({as, plant_.controls[*i].idle});
    }
  }
  for (const std::size_t position : part.constraints) {
    const Constraint& constraint = relevance_.constraints()[position];
    Formula formula = local(constraint.formula);
    if (constraint.under) {
      const std::size_t c = component_of[local(constraint.under->variable).index()];
      told[c][constraint.under->value.index()].push_back(std::move(formula));
    } else {
      own.interconnections.emplace_back(std::move(formula));
    }
  }
  for (std::size_t c = 0; c < told.size(); ++c) {
    for (std::size_t m = 0; m < told[c].size(); ++m) {
      own.components[c].modes[m].constraint = automata::conjunction(std::move(told[c][m]));
    }
  }
  return own;
}

FoundPreconditions Preconditions::of(ComponentId component, TransitionId transition) {
  if (!has_states_) return {};
  const automata::Transition& t = plant_[component].transitions[transition.index()];
  std::vector<VariableId> about = variables_of(t.guard);
  about.push_back(plant_[component].mode);
  const automata::Relevance::Part part = relevance_.part(about);
  const Assignment source{plant_[component].mode, ValueId(t.from.index())};
  Key question = question_about(part, source);
  write(question, t.guard, number_);
  const FoundPreconditions* known = found_.find(question);
  if (known == nullptr) {
    known = &found_.add(std::move(question),
                        PreconditionFinder(plant_of(part), local(source), local(t.guard)).preconditions());
  }
  // Numbers ascend with variables, so what was sorted stays sorted.
  FoundPreconditions result = *known;
  for (Precondition& precondition : result.preconditions) {
    for (Requirement& r : precondition) r.variable = part.variables[r.variable.index()];
  }
  return result;
}

bool Preconditions::possible(ComponentId component, ModeId mode) {
  if (!has_states_) return false;
  const VariableId variable = plant_[component].mode;
  const automata::Relevance::Part part = relevance_.part({variable});
  if (part.constraints.empty()) return true;
  const Assignment asked{variable, ValueId(mode.index())};
  Key question = question_about(part, asked);
  const bool* known = possible_.find(question);
  if (known == nullptr) {
    const Assignment own = local(asked);
    known = &possible_.add(std::move(question), automata::model_theory(plant_of(part)).consistent({&own, 1}));
  }
  return *known;
}

}  // namespace rmpl::runtime
