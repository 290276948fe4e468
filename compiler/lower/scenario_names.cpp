// The names of a scenario.
// SPDX-License-Identifier: MIT
#include "compiler/lower/scenario_names.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "automata/software/software_in.hpp"
#include "compiler/check/mention.hpp"
#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::VariableId;
using grammar::Code;

ScenarioNames::ScenarioNames(const Part& plant, grammar::Diagnostics& diagnostics)
    : part_(plant),
      plant_(plant.plant),
      diagnostics_(diagnostics),
      resolver_(plant_, &plant.declared, diagnostics),
      observables_(plant_.observables.begin(), plant_.observables.end()) {
  for (std::size_t c = 0; c < plant_.components.size(); ++c) {
    components_.emplace(plant_.components[c].mode, automata::ComponentId(c));
  }
  for (const automata::Control& control : plant_.controls) controls_.insert(control.variable);
}

std::optional<Assignment> ScenarioNames::start_mode(const grammar::AssignmentText& text) {
  const std::vector<Assignment> meant = modes(text, Moment::start);
  if (meant.size() == 1) return meant.front();
  if (meant.size() > 1) report_several(text, *resolver_.assignment(text.variable, text.value), meant);
  return std::nullopt;
}

std::optional<automata::ForcedMode> ScenarioNames::fault(const grammar::AssignmentText& text) {
  const std::vector<Assignment> meant = modes(text, Moment::fault);
  if (meant.empty()) return std::nullopt;
  const Assignment mode = meant.front();
  const Assignment told = *resolver_.assignment(text.variable, text.value);
  if (std::any_of(meant.begin(), meant.end(), [&](const Assignment& m) { return m.variable != mode.variable; })) {
    report_several(text, told, meant);
    return std::nullopt;
  }
  automata::ForcedMode forced{{}, components_.at(mode.variable), automata::ModeId(mode.value.index()), {}};
  if (told != mode) forced.told = told;
  for (std::size_t m = 1; m < meant.size(); ++m) forced.also.emplace_back(meant[m].value.index());
  return forced;
}

std::optional<Assignment> ScenarioNames::reading(const grammar::AssignmentText& text) {
  const auto reading = resolver_.assignment(text.variable, text.value);
  if (!reading || observables_.count(reading->variable) != 0) return reading;
  std::vector<std::string> names;
  for (const VariableId id : plant_.observables) names.push_back(plant_.variables.name(id));
  const bool mode = components_.count(reading->variable) != 0;
  auto& error = diagnostics_.error(Code::scenario_not_observable, text.variable.span,
                                   backquoted(text.variable.text) +
                                       (mode ? " is a component, and no sensor reads its mode" : " is not observable") +
                                       (names.empty() ? "" : ", expected " + one_of(names)));
  if (!mode) error.suggestion = "declare it in the plant: `observe " + text.variable.text + ";`";
  return std::nullopt;
}

std::optional<Assignment> ScenarioNames::command(const grammar::AssignmentText& text) {
  const auto command = resolver_.assignment(text.variable, text.value);
  if (!command || controls_.count(command->variable) != 0) return command;
  report_no_control(command->variable, text.variable.span);
  return std::nullopt;
}

std::optional<automata::Formula> ScenarioNames::condition(const grammar::Constraint& constraint) {
  return resolver_.resolve(constraint);
}

void ScenarioNames::check_trigger(const automata::Formula& trigger, bool command, const grammar::Constraint& text) {
  for (const VariableId id : automata::variables_of(trigger)) {
    if (command ? controls_.count(id) != 0 : components_.count(id) != 0) continue;
    const std::string& name = plant_.variables.name(id);
    if (command) {
      report_no_control(id, mention_of(name, text));
      continue;
    }
    auto& error = diagnostics_.error(Code::scenario_not_a_mode, mention_of(name, text),
                                     backquoted(name) + " is no component of plant " + backquoted(plant_.name));
    note_domain(error, id);
  }
}

std::vector<Assignment> ScenarioNames::modes(const grammar::AssignmentText& text, Moment moment) {
  const auto mode = resolver_.assignment(text.variable, text.value);
  if (!mode) return {};
  if (components_.count(mode->variable) != 0) return {*mode};
  std::vector<Assignment> meant = telling(*mode, moment);
  if (!meant.empty()) return meant;
  const bool software = automata::software_in(plant_) != nullptr;
  const std::string which = moment == Moment::start ? "no start" : "no fault";
  auto& error = diagnostics_.error(
      Code::scenario_not_a_mode, text.variable.span,
      backquoted(text.variable.text) + " is an attribute, expected a component" +
          (software ? ": " + which + " of software tells that it is " + backquoted(text.value.text) : ""));
  note_domain(error, mode->variable);
  return {};
}

/// The modes of software that tell it, as a conjunct of their own.
std::vector<Assignment> ScenarioNames::telling(Assignment told, Moment moment) const {
  std::vector<Assignment> result;
  const automata::Formula wanted = automata::is(told.variable, told.value);
  for (const automata::Component& component : plant_.components) {
    if (!component.software) continue;
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const bool meant = moment == Moment::start ? component.initial[m] > 0 : component.modes[m].fault;
      if (!meant) continue;
      const std::vector<automata::Formula> parts = automata::conjuncts_of(component.modes[m].constraint);
      if (std::find(parts.begin(), parts.end(), wanted) == parts.end()) continue;
      result.push_back({component.mode, automata::ValueId(m)});
    }
  }
  return result;
}

void ScenarioNames::report_several(const grammar::AssignmentText& text, Assignment told,
                                   const std::vector<Assignment>& telling) {
  const automata::Variables& variables = plant_.variables;
  std::vector<std::string> names;
  names.reserve(telling.size());
  for (const Assignment& one : telling) names.push_back(variables.name(one.variable) + " = " + variables.value(one));
  auto& error = diagnostics_.error(Code::scenario_not_a_mode, text.variable.span,
                                   std::to_string(telling.size()) + " modes of software tell that " +
                                       backquoted(variables.name(told.variable)) + " is " +
                                       backquoted(variables.value(told)) + ", expected one of them");
  error.suggestion = "name the mode: " + one_of(names);
}

void ScenarioNames::report_no_control(VariableId id, grammar::Span span) {
  auto& error = diagnostics_.error(
      Code::scenario_not_a_command, span,
      backquoted(plant_.variables.name(id)) + " is no control variable of plant " + backquoted(plant_.name));
  note_domain(error, id);
}

void ScenarioNames::note_domain(grammar::Diagnostic& error, VariableId id) {
  if (id.index() < part_.declared.size()) error.notes.push_back({part_.declared[id.index()], "its domain is here"});
}

}  // namespace rmpl::compiler
