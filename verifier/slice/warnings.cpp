// Questions that a model decides, and answers that say less than it seems.
// SPDX-License-Identifier: MIT
#include "verifier/slice/warnings.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "automata/assignment_text.hpp"
#include "automata/controls.hpp"
#include "verifier/property/held_command.hpp"
#include "verifier/slice/empty_claims.hpp"

namespace rmpl::verifier {

namespace {

void add_commands(std::vector<QuestionWarning>& warnings, const Property& property, const automata::Plant& plant) {
  std::set<automata::VariableId> told;
  for (const automata::Formula& formula : formulas_of(property)) {
    for (const automata::VariableId variable : automata::variables_of(formula)) {
      if (!automata::is_control(plant, variable) || !told.insert(variable).second) continue;
      warnings.push_back({"'" + plant.variables.name(variable) +
                          "' is a control: the check is about states, which permit every value of a control and imply "
                          "none; a flight uses the value that is commanded"});
    }
  }
}

std::optional<std::string> warning_of_knowledge(const std::vector<automata::Formula>& atoms,
                                                const automata::Plant& plant) {
  std::string text;
  std::set<automata::Knowing> kinds;
  for (const automata::Formula& atom : atoms) {
    if (atom.knowing == automata::Knowing::no_plan) continue;
    text += (text.empty() ? "'" : ", '") + to_text(atom, plant.variables) + "'";
    kinds.insert(atom.knowing);
  }
  if (text.empty()) return std::nullopt;
  text += kinds.size() == 1 && text.find(", ") == std::string::npos ? " is" : " are";
  text += " checked with the estimate taken as the truth: ";
  std::string readings;
  const auto add = [&](automata::Knowing kind, const char* reading) {
    if (kinds.contains(kind)) readings += (readings.empty() ? "" : ", ") + std::string(reading);
  };
  add(automata::Knowing::surprise, "'surprise' never holds");
  add(automata::Knowing::possible, "'possible' asks what the state permits");
  add(automata::Knowing::likely, "'likely' asks what the state implies");
  return text + readings;
}

/// What conditions ask of the executive's knowledge is judged by the truth.
void add_knowledge(std::vector<QuestionWarning>& warnings, const Property& property, const automata::Plant& plant,
                   const automata::Program* program) {
  std::vector<automata::Formula> atoms;
  if (program != nullptr && std::holds_alternative<ProgramProperty>(property)) atoms = knowledge_asked_by(*program);
  for (const automata::Formula& formula : formulas_of(property)) collect_knowledge(formula, atoms);
  if (const auto warning = warning_of_knowledge(atoms, plant)) warnings.push_back({*warning});
}

void add_empty_claim(std::vector<QuestionWarning>& warnings, const Question& question, Slices& slices) {
  const Property& property = question.property;
  const automata::Variables& variables = slices.plant().variables;
  if (const auto event = out_of_reach(slices, property, question.options)) {
    warnings.push_back({"'" + automata::to_text(*event, variables) +
                            "' needs a fault, but none is permitted: permit up to K faults with --faults K, or with "
                            "'faults K' in a property file",
                        true});
  }
  if (const auto* reachability = std::get_if<Reachability>(&property)) {
    if (const auto why = vacuity_of_never(slices, reachability->target, question.options.entailed)) {
      warnings.push_back({"no state " + std::string(*why == Vacuity::unsatisfiable ? "satisfies" : "implies") + " '" +
                              automata::to_text(reachability->target, variables) +
                              "': that it is unreachable says nothing about the plant",
                          true});
    }
  }
  if (const auto promise = there_anyway(slices, property)) {
    warnings.push_back({"every state satisfies '" + automata::to_text(*promise, variables) +
                            "': the claim says nothing about the plant",
                        true});
  } else if (answers_itself(slices, property)) {
    warnings.push_back({"every state that satisfies '" + automata::to_text(formulas_of(property).front(), variables) +
                            "' satisfies the response too: the claim says nothing about the plant",
                        true});
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
  return "in dense time a command lasts for an instant, and time passes with all controls idle. The check did not "
         "cover that '" +
         component.name + "' stays in '" + component.modes[held->mode.index()].name + "' while " +
         to_text(plant.variables, held->command) +
         " is held; check it with --time T, or with a program that holds the command";
}

}  // namespace

std::vector<QuestionWarning> warnings_of(const Question& question, Slices& slices, const automata::Program* program) {
  std::vector<QuestionWarning> warnings;
  add_commands(warnings, question.property, slices.plant());
  add_knowledge(warnings, question.property, slices.plant(), program);
  const std::vector<automata::Formula> asked = formulas_of(question.property);
  if (std::any_of(asked.begin(), asked.end(), automata::has_knowledge)) return warnings;
  // Where nothing starts that is to be told, and no more.
  if (slices.start(question.options.from)) add_empty_claim(warnings, question, slices);
  return warnings;
}

std::optional<std::string> warning_of(const Question& question, const Answer& answer, Slices& slices) {
  if (!answer.startless) return held_command(question, answer, slices);
  return no_start;
}

}  // namespace rmpl::verifier
