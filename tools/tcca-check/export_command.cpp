// tcca-check export: the question of reachability or safety in the language of another tool.
// SPDX-License-Identifier: MIT
#include <memory>
#include <sstream>

#include "automata/software/software_in.hpp"
#include "base/error.hpp"
#include "base/limit_error.hpp"
#include "tools/shared/models.hpp"
#include "tools/tcca-check/check_options.hpp"
#include "tools/tcca-check/commands.hpp"
#include "verifier/export/prism.hpp"
#include "verifier/export/write.hpp"
#include "verifier/property/initial_modes.hpp"
#include "verifier/slice/slices.hpp"
#include "verifier/slice/warnings.hpp"

namespace rmpl::tools {
namespace {

enum class Tool { tchecker, uppaal, prism, jani };

std::string name_of(Tool tool) {
  switch (tool) {
    case Tool::tchecker:
      return "tchecker";
    case Tool::uppaal:
      return "uppaal";
    case Tool::prism:
      return "prism";
    case Tool::jani:
      return "jani";
  }
  return {};
}

struct ExportOptions {
  std::string main;  ///< the definition that a model program starts with; empty: the one that no other calls
  std::string model;
  Tool tool = Tool::tchecker;
  std::string target, never;
  Freedom freedom;
  verifier::Commands commands = verifier::Commands::one;
  bool whole = false;
  Budget budget;
};

/// For a tool of dense time.
void write_dense(std::ostream& out, automata::PlantStep& step, const verifier::ExportQuestion& question,
                 const ExportOptions& options, const verifier::Limits& limits) {
  if (const automata::Component* software = automata::software_in(step.plant())) {
    throw base::InputError("'" + software->name + "' is software, which takes a step a cycle, and " +
                           name_of(options.tool) + " reads time as dense; expected --format prism");
  }
  if (options.freedom.period) {
    throw base::InputError(name_of(options.tool) + " reads time as dense; use it without a period");
  }
  const auto write = options.tool == Tool::tchecker ? verifier::write_tchecker
                     : options.tool == Tool::uppaal ? verifier::write_uppaal
                                                    : verifier::write_jani;
  write(out, step.plant(), verifier::network_of(step, question, limits));
}

void write_steps(std::ostream& out, automata::PlantStep& step, const verifier::ExportQuestion& question,
                 const ExportOptions& options, const verifier::Limits& limits) {
  if (!options.freedom.period) {
    throw base::InputError("prism has no dense time; give the period of a step, as in --time 0.5s");
  }
  verifier::write_prism(out, step, question, *options.freedom.period, limits);
}

/// What is written: of the cone of the question, where it has a start.
void write(std::ostream& out, const automata::Plant& plant, verifier::ExportQuestion question,
           const ExportOptions& options, const verifier::Limits& limits) {
  const auto write_one = options.tool == Tool::prism ? write_steps : write_dense;
  verifier::Slices slices(plant);
  const bool starts = slices.start(question.from).has_value();
  if (!starts) {
    if (!question.from.empty()) verifier::refuse_start();
    tell(std::string("warning: ") + verifier::no_start);
  }
  if (options.whole || !starts) {
    automata::PlantStep step(plant);
    return write_one(out, step, question, options, limits);
  }
  const std::vector<automata::Formula> asked{question.target};
  const verifier::Part part = slices.part(slices.cone(asked), asked);
  question.target = part.into(question.target);
  question.from = part.into(question.from);
  automata::PlantStep step(part.plant());
  write_one(out, step, question, options, limits);
}

ExitStatus run(const ExportOptions& options, const Common& common) {
  const compiler::Compilation compilation =
      load({options.model}, common, {.main = options.main, .model_is_plant = true});
  const automata::Plant& plant = only_plant(compilation.document(), options.model);
  const verifier::ExportQuestion question{
      options.never.empty() ? formula_option(options.target, plant, "--target", common)
                            : formula_option(options.never, plant, "--never", common),
      options.freedom.entailed, options.freedom.faults.value_or(0), options.commands,
      assignments_option(options.freedom.from, plant, "--from", common)};
  verifier::demand_modes(plant, question.from);
  std::ostringstream out;  // as a whole or not at all: what cannot be said may be met late
  out.exceptions(std::ios::badbit | std::ios::failbit);
  try {
    write(out, plant, question, options, limits(options.budget, common));
  } catch (const verifier::LimitReached& reached) {
    const bool signal = reached.limit == verifier::Limit::interrupt;
    throw base::LimitError(std::string(signal ? "interrupted" : "a limit was reached") +
                           " before all mode combinations were found: nothing is written");
  } catch (const std::ios::failure&) {
    throw base::LimitError("out of memory: nothing is written");
  }
  print_file(std::move(out).str());
  return ExitStatus::done;
}

constexpr const char* export_notes =
    R"(Exit status: 0 it is written, 2 the command line or an input is wrong, 3 a limit or a signal came before it
was whole: nothing is written, 4 an internal error.)";

}  // namespace

void add_export(Program& program) {
  Command command = program.add_command("export", "write the same question for another tool");
  const auto options = std::make_shared<ExportOptions>();
  add_model(command, options->model, options->main);
  add_choice<Tool>(
      command, "--format", options->tool,
      {{"tchecker", Tool::tchecker}, {"uppaal", Tool::uppaal}, {"prism", Tool::prism}, {"jani", Tool::jani}},
      "the tool; all use dense time except prism, which uses the period of --time")
      .required();
  command.add_flag("--whole", options->whole, "export all components, not only those that the question depends on");
  Option target = add_text(command, "--target", options->target, "FORMULA", "the target formula");
  Option never = add_text(command, "--never", options->never, "FORMULA", "a formula that must never hold");
  command.require_one(target, never);
  add_freedom(command, options->freedom);
  add_commands(command, options->commands);
  add_budget(command, options->budget);
  command.footer(export_notes);
  program.add({command, [options, &common = program.common()] { return run(*options, common); }, AtSignal::tell});
}

}  // namespace rmpl::tools
