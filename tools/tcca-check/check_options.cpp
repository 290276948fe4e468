// Options of tcca-check that several subcommands take.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/check_options.hpp"

#include <cstdio>
#include <set>

#include "automata/assignment_text.hpp"
#include "automata/controls.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/progress.hpp"
#include "verifier/property/held_command.hpp"
#include "verifier/slice/empty_claims.hpp"

namespace rmpl::tools {

using verifier::Commands;
using verifier::Verdict;

void add_freedom(CLI::App& command, Freedom& freedom, bool formula) {
  const auto period = [&freedom](const std::string& text) {
    freedom.dense = text == "dense";
    return freedom.dense ? std::nullopt : std::optional(positive_duration(text));
  };
  add_read(command, "--time", freedom.period, period,
           "dense time (the default), or the period at whose multiples steps happen")
      ->option_text("dense|T");
  constexpr std::uint64_t most = 1'000'000;
  add_whole_number(command, "--faults", freedom.faults, 0, most, "the most faults that may happen (default: 0)")
      ->option_text("K");
  if (formula) {
    command.add_flag("--entailed", freedom.entailed,
                     "a formula holds where the constraints imply it, not where they allow it");
  }
  add_text(command, "--from", freedom.from, "MODES",
           "modes to start in, such as 'engine = off'; what is not named starts as in the plant");
}

void add_budget(CLI::App& command, Budget& budget) {
  constexpr std::uint64_t most = 1'000'000'000'000;
  add_whole_number(command, "--max-states", budget.states, 1, most, "give up after so many symbolic states");
  add_read(command, "--timeout", budget.time, duration, "give up after so much time")->option_text("T");
  add_read(command, "--max-memory", budget.bytes, memory_size, "give up when so much memory is in use")
      ->option_text("BYTES[K|M|G]");
}

verifier::Limits limits(const Budget& budget, const Common& common) {
  watch_for_interruption();
  verifier::Limits result{budget.states, std::nullopt, budget.bytes, &interruption(), nullptr};
  if (budget.time && !budget.time->is_infinite()) result.time.emplace(budget.time->seconds());
  if (progress_is_seen(common.quiet)) {
    result.report = [](const verifier::Progress& p) {
      char seconds[32];
      std::snprintf(seconds, sizeof seconds, "%.0f", p.seconds);
      show_progress(std::string(seconds) + " s: " + std::to_string(p.states) + " states, " + std::to_string(p.waiting) +
                    " unexplored, " + std::to_string(p.steps.value_or(p.level)) + (p.steps ? " steps" : " faults"));
    };
  }
  return result;
}

void add_report(CLI::App& command, std::string& path) {
  add_text(command, "--report", path, "OUT.html", "write a page to look at the traces in a browser, all in one file");
}

void add_model(CLI::App& command, std::string& model) {
  command.add_option("MODEL", model, "the plant: .tcca or compiled .json; - for standard input")->required();
}

void add_commands(CLI::App& command, Commands& commands) {
  add_choice<Commands>(command, "--commands", commands,
                       {{"none", Commands::none}, {"one", Commands::one}, {"any", Commands::any}},
                       "how many controls may be off their idle value in one step (default: one)");
}

CLI::Option* add_text(CLI::App& command, const std::string& name, std::string& text, const char* type,
                      const char* description) {
  return command.add_option(name, text, description)->option_text(type);
}

CLI::Option* add_texts(CLI::App& command, const std::string& name, std::vector<std::string>& texts, const char* type,
                       const char* description) {
  return repeatable(command.add_option(name, texts, description)->option_text(type));
}

ExitStatus status_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return ExitStatus::done;
    case Verdict::violated:
      return ExitStatus::violated;
    case Verdict::undecided:
      return ExitStatus::undecided;
  }
  return ExitStatus::internal_error;
}

void warn_of_commands(const std::vector<verifier::Property>& asked, const automata::Plant& plant) {
  std::set<automata::VariableId> told;
  for (const verifier::Property& property : asked) {
    for (const automata::Formula& formula : verifier::formulas_of(property)) {
      for (const automata::VariableId variable : automata::variables_of(formula)) {
        if (!automata::is_control(plant, variable) || !told.insert(variable).second) continue;
        tell("warning: '" + plant.variables.name(variable) +
             "' is commanded: what is asked is about states, which allow any value of it and imply none; a flight sees "
             "the command in force");
      }
    }
  }
}

bool warn_of_held_command(const verifier::Question& question, const verifier::Answer& answer,
                          verifier::Slices& slices) {
  const verifier::CheckOptions& options = question.options;
  const bool none_found = answer.verdict != Verdict::undecided && !answer.witness;
  const bool of_program = std::holds_alternative<verifier::ProgramProperty>(question.property);
  if (options.period || options.commands == verifier::Commands::none || !none_found || of_program) return false;
  const automata::Plant& plant = slices.plant();
  const auto held = verifier::find_held_mode(plant, slices.cone(formulas_of(question.property)));
  if (!held) return false;
  const automata::Component& component = plant[held->component];
  tell("warning: in dense time commands are given at an instant, and time passes with all controls idle: that '" +
       component.name + "' stays in '" + component.modes[held->mode.index()].name + "' while " +
       to_text(plant.variables, held->command) +
       " is held was not looked at; --time T looks at it, and a program where it holds it");
  return true;
}

void warn_of_empty_claim(const verifier::Property& property, const verifier::CheckOptions& options,
                         verifier::Slices& slices) {
  const automata::Variables& variables = slices.plant().variables;
  if (const auto event = verifier::out_of_reach(slices, property, options)) {
    tell("warning: '" + automata::to_text(*event, variables) +
         "' takes a fault, and none is permitted: --faults K, or 'faults K' in a property file, permits up to K");
  }
  if (const auto promise = verifier::there_anyway(slices, property)) {
    tell("warning: every state satisfies '" + automata::to_text(*promise, variables) +
         "': that it comes says nothing of the plant");
  } else if (verifier::answers_itself(slices, property)) {
    const std::vector<automata::Formula> said = verifier::formulas_of(property);
    tell("warning: whatever satisfies '" + automata::to_text(said.front(), variables) +
         "' is its own answer: the response says nothing of the plant");
  }
}

void warn_of_no_start(const char* consequence) {
  tell(std::string("warning: no initial state is possible: the initial modes contradict the interconnections, so ") +
       consequence);
}

}  // namespace rmpl::tools
