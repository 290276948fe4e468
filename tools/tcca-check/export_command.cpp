// tcca-check export: the question of reachability or safety in the language of another tool.
// SPDX-License-Identifier: MIT
#include <memory>
#include <sstream>

#include "base/error.hpp"
#include "base/limit_error.hpp"
#include "tools/shared/models.hpp"
#include "tools/tcca-check/check_options.hpp"
#include "tools/tcca-check/commands.hpp"
#include "verifier/export/prism.hpp"
#include "verifier/export/write.hpp"
#include "verifier/property/initial_modes.hpp"
#include "verifier/slice/warnings.hpp"

namespace rmpl::tools {
namespace {

enum class Tool { tchecker, uppaal, prism };

struct Options {
  std::string model;
  Tool tool = Tool::tchecker;
  std::string target, never;
  Freedom freedom;
  verifier::Commands commands = verifier::Commands::one;
  Budget budget;
};

/// For a tool of dense time.
void write_dense(std::ostream& out, automata::PlantStep& step, const verifier::ExportQuestion& question,
                 const Options& options, const verifier::Limits& limits) {
  const bool uppaal = options.tool == Tool::uppaal;
  if (options.freedom.period) {
    throw base::InputError(std::string(uppaal ? "uppaal" : "tchecker") + " reads time as dense; expected no period");
  }
  const verifier::TimedAutomaton automaton = verifier::unfold(step, question, limits);
  if (automaton.locations.empty()) {
    if (!question.from.empty()) verifier::refuse_start();
    tell(std::string("warning: ") + verifier::no_start);
  }
  (uppaal ? verifier::write_uppaal : verifier::write_tchecker)(out, step.plant(), automaton);
}

void write_steps(std::ostream& out, automata::PlantStep& step, const verifier::ExportQuestion& question,
                 const Options& options, const verifier::Limits& limits) {
  if (!options.freedom.period) {
    throw base::InputError("prism has steps and no dense time; expected a period, as in --time 0.5s");
  }
  verifier::write_prism(out, step, question, *options.freedom.period, limits);
}

ExitStatus run(const Options& options, const Common& common) {
  const compiler::Compilation compilation = load({options.model}, common);
  const automata::Plant& plant = only_plant(compilation.document(), options.model);
  const verifier::ExportQuestion question{
      options.never.empty() ? formula_option(options.target, plant, "--target", common)
                            : formula_option(options.never, plant, "--never", common),
      options.freedom.entailed, options.freedom.faults.value_or(0), options.commands,
      assignments_option(options.freedom.from, plant, "--from", common)};
  verifier::demand_modes(plant, question.from);
  automata::PlantStep step(plant);
  std::ostringstream out;  // as a whole or not at all: what cannot be said may be met late
  out.exceptions(std::ios::badbit | std::ios::failbit);
  try {
    (options.tool == Tool::prism ? write_steps : write_dense)(out, step, question, options,
                                                              limits(options.budget, common));
  } catch (const verifier::LimitReached&) {
    throw base::LimitError("a limit was reached before all mode combinations were met: nothing is written");
  } catch (const std::ios::failure&) {
    throw base::LimitError("out of memory: nothing is written");
  }
  print(std::move(out).str());
  return ExitStatus::done;
}

}  // namespace

void add_export(Program& program) {
  CLI::App* command =
      program.app().add_subcommand("export", "the same question for another tool, which has to give the same answer");
  const auto options = std::make_shared<Options>();
  add_model(*command, options->model);
  add_choice<Tool>(*command, "--format", options->tool,
                   {{"tchecker", Tool::tchecker}, {"uppaal", Tool::uppaal}, {"prism", Tool::prism}},
                   "which tool is asked: the first two in dense time, prism with the period of --time")
      ->required();
  CLI::Option* target = add_text(*command, "--target", options->target, "FORMULA", "what is to be reached");
  CLI::Option* never = add_text(*command, "--never", options->never, "FORMULA", "what is never to hold");
  require_one(*command, target, never);
  add_freedom(*command, options->freedom);
  add_commands(*command, options->commands);
  add_budget(*command, options->budget);
  program.add({command, [options, &common = program.common()] { return run(*options, common); }});
}

}  // namespace rmpl::tools
