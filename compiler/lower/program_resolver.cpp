// Constraints of programs become conditions and goals.
// SPDX-License-Identifier: MIT
#include "compiler/lower/program_resolver.hpp"

#include <algorithm>
#include <utility>

#include "compiler/check/mention.hpp"
#include "compiler/lower/timing.hpp"

namespace rmpl::compiler {

using automata::ClockId;
using automata::Formula;
using automata::ValueId;
using automata::VariableId;
using grammar::Code;
using grammar::Name;

namespace {

/// Without a plant a program's variables take the values it mentions, up to this many.
constexpr std::size_t open_domain_limit = 4096;

Vocabulary vocabulary_of(const automata::Program& program, bool model, const Part* plant) {
  if (model) return {program.variables, &plant->declared, "the model program", Code::unknown_name};
  if (plant == nullptr) return {program.variables, nullptr, "the program", Code::unknown_name};
  return {program.variables, &plant->declared, "plant " + backquoted(plant->plant.name), Code::not_in_plant,
          software_of(plant->plant)};
}

automata::Comparison comparison_of(grammar::ClockRelation relation) {
  switch (relation) {
    case grammar::ClockRelation::less:
      return automata::Comparison::less;
    case grammar::ClockRelation::at_most:
      return automata::Comparison::at_most;
    case grammar::ClockRelation::greater:
      return automata::Comparison::greater;
    case grammar::ClockRelation::at_least:
      return automata::Comparison::at_least;
  }
  return automata::Comparison::less;
}

}  // namespace

ProgramResolver::ProgramResolver(automata::Program& program, bool model, const Part* plant,
                                 grammar::Diagnostics& diagnostics)
    : Resolver(vocabulary_of(program, model, plant), diagnostics), program_(program), model_(model), plant_(plant) {
  if (!model) ask_of_knowledge(std::nullopt);
  if (plant == nullptr) return;
  program.variables = plant->plant.variables;
  for (const automata::Component& component : plant->plant.components) modes_.insert(component.mode);
}

const Passed* ProgramResolver::passed(const std::string& name) const {
  if (environment_ == nullptr) return nullptr;
  const auto known = environment_->parameters.find(name);
  return known == environment_->parameters.end() ? nullptr : &known->second;
}

const Name* ProgramResolver::own_clock(const std::string& name) const {
  if (environment_ == nullptr) return nullptr;
  const auto known = environment_->clocks.find(name);
  return known == environment_->clocks.end() ? nullptr : &known->second;
}

void ProgramResolver::annotate(grammar::Diagnostic& diagnostic) {
  if (environment_ == nullptr || environment_->call == nullptr || environment_->parameters.empty()) return;
  diagnostic.notes.push_back({environment_->call->definition.span, "in the expansion of this call"});
}

std::optional<Name> ProgramResolver::meaning(const Name& name) {
  if (const Name* clock = own_clock(name.text)) return Name{name.span, clock->text};
  const Passed* argument = passed(name.text);
  if (argument == nullptr) return name;
  if (const auto* stands_for = std::get_if<Name>(argument)) return *stands_for;
  if (const auto* constraint = std::get_if<PassedConstraint>(argument)) {
    auto& error =
        diagnostics().error(Code::wrong_argument, name.span,
                            "parameter " + backquoted(name.text) + " stands for a constraint, and a name is needed");
    error.notes.push_back({constraint->constraint->span, "the argument is here"});
  }
  return std::nullopt;
}

Formula ProgramResolver::reference(const grammar::Reference& reference) {
  const Passed* argument = passed(reference.name.text);
  if (argument == nullptr) return Resolver::reference(reference);
  if (const auto* name = std::get_if<Name>(argument)) {
    auto& error = diagnostics().error(Code::wrong_argument, reference.name.span,
                                      "parameter " + backquoted(reference.name.text) + " stands for the name " +
                                          backquoted(name->text) + ", and a constraint is needed");
    error.notes.push_back({name->span, "the argument is here"});
    return automata::constant(true);
  }
  if (const auto* constraint = std::get_if<PassedConstraint>(argument)) {
    const Environment* inner = std::exchange(environment_, constraint->environment);
    Formula formula = resolve(*constraint->constraint);
    environment_ = inner;
    return formula;
  }
  return automata::constant(true);
}

ClockId ProgramResolver::clock_named(const std::string& name) {
  const auto [known, fresh] = clocks_.emplace(name, ClockId(program_.clocks.size()));
  if (fresh) program_.clocks.push_back(name);
  return known->second;
}

void ProgramResolver::report_clock(const Name& clock) {
  auto& error = diagnostics().error(Code::clock_in_model, clock.span,
                                    "clock " + backquoted(clock.text) + " in a model program, which counts steps");
  error.suggestion = "wait step by step: `next next …`";
  annotate(error);
}

bool ProgramResolver::lost_its_meaning(const Name& name) const { return model_ && is_broken(*plant_, name.text); }

Formula ProgramResolver::clock(const grammar::ClockBound& bound) {
  if (model_) {
    report_clock(bound.clock);
    return automata::constant(true);
  }
  const auto name = meaning(bound.clock);
  const auto ticks = ticks_of(bound.bound, diagnostics());
  if (!name || !ticks) return automata::constant(true);
  return automata::clock_bound(clock_named(name->text), comparison_of(bound.relation), *ticks);
}

bool ProgramResolver::report_variable(const Name& clock) {
  const auto variable = program_.variables.find(clock.text);
  if (!variable) return false;
  auto& error =
      diagnostics().error(Code::duplicate_name, clock.span,
                          "clock " + backquoted(clock.text) + " has the name of a variable of " + vocabulary().owner);
  if (const auto place = vocabulary().declaration(*variable)) {
    error.notes.push_back({*place, "the domain of the variable is here"});
  }
  annotate(error);
  return true;
}

std::optional<ClockId> ProgramResolver::own(const Name& declared, const std::string& unique) {
  if (report_variable(declared)) return std::nullopt;
  return clock_named(unique);
}

std::optional<ClockId> ProgramResolver::start(const Name& name) {
  const auto meant = meaning(name);
  if (!meant || report_variable(*meant)) return std::nullopt;
  return clock_named(meant->text);
}

std::optional<VariableId> ProgramResolver::variable(const Name& name) {
  if (closed() && own_clock(name.text) == nullptr) return Resolver::variable(name);
  const auto meant = meaning(name);
  if (!meant) return std::nullopt;
  if (const auto known = program_.variables.find(meant->text)) return known;
  if (clocks_.count(meant->text) != 0) {
    auto& error = diagnostics().error(Code::wrong_kind_of_name, meant->span,
                                      backquoted(name.text) + " is a clock, and a variable is needed");
    error.suggestion = "compare a clock with <, <=, > or >=";
    return std::nullopt;
  }
  const VariableId id = program_.variables.add({meant->text, {}});
  mentions_.emplace(id, name.span);
  return id;
}

void ProgramResolver::taken_for_value(const Name& name) {
  taken_for_values_.try_emplace({name.span.file, name.span.begin}, name);
}

void ProgramResolver::check_values() {
  for (const auto& [place, name] : taken_for_values_) {
    const auto variable = program_.variables.find(name.text);
    if (!variable && clocks_.count(name.text) == 0) continue;
    auto& error =
        diagnostics().error(variable ? Code::ambiguous_name : Code::wrong_kind_of_name, name.span,
                            backquoted(name.text) + (variable ? " is a variable of the program" : " is a clock") +
                                ", and may be a value here: without the plant it cannot be told");
    if (variable) error.notes.push_back({mentions_.at(*variable), "it is a variable here"});
    error.suggestion = variable ? "compile the program together with its plant" : "compare a clock with <, <=, > or >=";
  }
}

std::optional<ValueId> ProgramResolver::find_value(VariableId id, const std::string& value) {
  if (closed()) return Resolver::find_value(id, value);
  auto& values = seen_[id];
  if (const auto known = values.find(value); known != values.end()) return known->second;
  if (values.size() == open_domain_limit) {
    if (overflowed_.insert(id).second) {
      diagnostics().error(Code::too_large, mentions_.at(id),
                          backquoted(program_.variables.name(id)) + " takes more than " +
                              std::to_string(open_domain_limit) + " values, and no plant says which it has");
    }
    return ValueId(0);
  }
  return values.emplace(value, program_.variables.add_value(id, value)).first->second;
}

ProgramResolver::Goal ProgramResolver::goal(const grammar::Constraint& constraint) {
  Goals goals;
  ask_of_knowledge(goal_asks_no_knowledge);
  add_goals(constraint, goals);
  ask_of_knowledge(std::nullopt);
  return std::move(goals.goal);
}

void ProgramResolver::add_goals(const grammar::Constraint& constraint, Goals& goals) {
  if (const auto* truth = std::get_if<grammar::Truth>(&constraint.node)) {
    if (truth->value) return;
    annotate(diagnostics().error(Code::goal_out_of_reach, constraint.span, "`false` as a goal: nothing achieves it"));
  } else if (const auto* comparison = std::get_if<grammar::Comparison>(&constraint.node)) {
    add_comparison(*comparison, constraint, goals);
  } else if (const auto* conjunction = std::get_if<grammar::Conjunction>(&constraint.node)) {
    for (const grammar::Constraint& operand : conjunction->operands) add_goals(operand, goals);
  } else if (const auto* reference = std::get_if<grammar::Reference>(&constraint.node)) {
    const Passed* argument = passed(reference->name.text);
    const auto* passed_on = argument == nullptr ? nullptr : std::get_if<PassedConstraint>(argument);
    if (argument == nullptr) {
      const std::string& name = reference->name.text;
      auto& error = diagnostics().error(Code::wrong_kind_of_name, reference->name.span,
                                        "expected a step, found the lone name " + backquoted(name));
      error.suggestion = "a call is written `" + name + "()`, a goal `" + name + " = …`";
      return annotate(error);
    }
    if (passed_on == nullptr) {
      this->reference(*reference);
      return;
    }
    const Environment* inner = std::exchange(environment_, passed_on->environment);
    add_goals(*passed_on->constraint, goals);
    environment_ = inner;
  } else {
    add_constraint(constraint, goals);
  }
}

/// A conjunct that assigns no mode.
void ProgramResolver::add_constraint(const grammar::Constraint& constraint, Goals& goals) {
  Formula formula = resolve(constraint);
  if (has_clock(formula)) {
    auto& error = diagnostics().error(Code::clock_not_allowed, constraint.span,
                                      "a clock bound in a goal: no command can achieve it");
    error.suggestion = "wait for it: `when … donext …`";
    return;
  }
  if (report_commanded(formula, constraint) || formula.is_true()) return;
  goals.goal.constraints.push_back(std::move(formula));
}

/// Reports a goal that speaks of what is commanded: states do not tell it.
bool ProgramResolver::report_commanded(const Formula& formula, const grammar::Constraint& constraint) {
  if (!closed()) return false;
  const auto variables = variables_of(formula);
  for (const automata::Control& control : plant_->plant.controls) {
    if (!std::binary_search(variables.begin(), variables.end(), control.variable)) continue;
    const std::string& name = program_.variables.name(control.variable);
    auto& error =
        diagnostics().error(Code::goal_out_of_reach, mention_of(name, constraint),
                            backquoted(name) + " is commanded, and a goal says what commands are to bring about");
    error.suggestion = "name the mode that the command leads to";
    annotate(error);
    return true;
  }
  return false;
}

void ProgramResolver::add_comparison(const grammar::Comparison& comparison, const grammar::Constraint& whole,
                                     Goals& goals) {
  const auto id = variable(comparison.left);
  if (!id) return;
  const auto right = meaning(comparison.right);
  if (!right) return;
  // Attributes have values and no modes; `x = y` compares two components; and `x != v` assigns nothing.
  const bool mode = !closed() || modes_.count(*id) != 0;
  const bool other = closed() && !find_value(*id, right->text) && program_.variables.find(right->text);
  if (!comparison.equal || !mode || other) return add_constraint(whole, goals);
  const auto assignment = this->assignment(comparison.left, comparison.right);
  if (!assignment) return;
  if (vocabulary().meant(assignment->variable, assignment->value).size() > 1) return add_constraint(whole, goals);
  const auto [first, fresh] = goals.asked.emplace(assignment->variable, assignment->value);
  if (fresh) {
    goals.goal.modes.push_back(*assignment);
  } else if (first->second != assignment->value) {
    auto& error = diagnostics().error(Code::contradictory_goal, whole.span,
                                      "the goal asks for " + backquoted(program_.variables.name(*id)) + " to be both " +
                                          backquoted(program_.variables.value({*id, first->second})) + " and " +
                                          backquoted(program_.variables.value(*assignment)));
    annotate(error);
  }
}

Passed ProgramResolver::pass(const grammar::Argument& argument) {
  if (const auto* name = std::get_if<Name>(&argument.node)) {
    if (const Name* clock = own_clock(name->text)) return Passed{Name{name->span, clock->text}};
    const Passed* own = passed(name->text);
    return own != nullptr ? *own : Passed{*name};
  }
  const auto& constraint = std::get<grammar::Constraint>(argument.node);
  if (const auto* reference = std::get_if<grammar::Reference>(&constraint.node)) {
    if (const Name* clock = own_clock(reference->name.text)) return Passed{Name{reference->name.span, clock->text}};
    const Passed* own = passed(reference->name.text);
    return own != nullptr ? *own : Passed{reference->name};
  }
  const Formula formula = resolve(constraint);  // which may add a clock: not while its name is asked for
  return PassedConstraint{&constraint, environment_, to_text(formula, program_.variables, program_.clocks)};
}

}  // namespace rmpl::compiler
