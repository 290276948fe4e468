// Questions that a model decides, and answers that say less than it seems.
// SPDX-License-Identifier: MIT
#include "verifier/slice/warnings.hpp"

#include <set>

#include "automata/assignment_text.hpp"
#include "automata/controls.hpp"
#include "verifier/property/held_command.hpp"
#include "verifier/slice/empty_claims.hpp"

namespace rmpl::verifier {

namespace {

void add_commands(std::vector<std::string>& warnings, const Property& property, const automata::Plant& plant) {
  std::set<automata::VariableId> told;
  for (const automata::Formula& formula : formulas_of(property)) {
    for (const automata::VariableId variable : automata::variables_of(formula)) {
      if (!automata::is_control(plant, variable) || !told.insert(variable).second) continue;
      warnings.push_back("'" + plant.variables.name(variable) +
                         "' is commanded: what is asked is about states, which allow any value of it and imply none; a "
                         "flight sees the command in force");
    }
  }
}

void add_empty_claim(std::vector<std::string>& warnings, const Question& question, Slices& slices) {
  const Property& property = question.property;
  const automata::Variables& variables = slices.plant().variables;
  if (const auto event = out_of_reach(slices, property, question.options)) {
    warnings.push_back("'" + automata::to_text(*event, variables) +
                       "' takes a fault, and none is permitted: --faults K, or 'faults K' in a property file, permits "
                       "up to K");
  }
  if (const auto* reachability = std::get_if<Reachability>(&property)) {
    if (const auto why = vacuity_of_never(slices, reachability->target, question.options.entailed)) {
      warnings.push_back("no state whatever " + std::string(*why == Vacuity::unsatisfiable ? "satisfies" : "implies") +
                         " '" + automata::to_text(reachability->target, variables) +
                         "': that it is not reached says nothing of the plant");
    }
  }
  if (const auto promise = there_anyway(slices, property)) {
    warnings.push_back("every state satisfies '" + automata::to_text(*promise, variables) +
                       "': that it comes says nothing of the plant");
  } else if (answers_itself(slices, property)) {
    warnings.push_back("whatever satisfies '" + automata::to_text(formulas_of(property).front(), variables) +
                       "' is its own answer: the response says nothing of the plant");
  }
}

std::optional<std::string> held_command(const Question& question, const Answer& answer, Slices& slices) {
  const CheckOptions& options = question.options;
  const bool none_found = answer.verdict != Verdict::undecided && !answer.witness;
  const bool of_program = std::holds_alternative<ProgramProperty>(question.property);
  if (options.period || options.commands == Commands::none || !none_found || of_program) return std::nullopt;
  const automata::Plant& plant = slices.plant();
  const auto held = find_held_mode(plant, slices.cone(formulas_of(question.property)));
  if (!held) return std::nullopt;
  const automata::Component& component = plant[held->component];
  return "in dense time commands are given at an instant, and time passes with all controls idle: that '" +
         component.name + "' stays in '" + component.modes[held->mode.index()].name + "' while " +
         to_text(plant.variables, held->command) +
         " is held was not looked at; --time T looks at it, and a program where it holds it";
}

}  // namespace

std::vector<std::string> warnings_of(const Question& question, Slices& slices) {
  std::vector<std::string> warnings;
  add_commands(warnings, question.property, slices.plant());
  // Where nothing starts that is to be told, and no more.
  if (slices.start(question.options.from)) add_empty_claim(warnings, question, slices);
  return warnings;
}

std::optional<std::string> warning_of(const Question& question, const Answer& answer, Slices& slices) {
  if (!answer.startless) return held_command(question, answer, slices);
  return no_start;
}

}  // namespace rmpl::verifier
