// Checking one property of a model program.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/model_check.hpp"

#include "base/error.hpp"
#include "tools/shared/models.hpp"
#include "verifier/marking/check.hpp"
#include "verifier/marking/report.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::tools {

namespace {

void refuse_what_is_of_plants(const PropertyOptions& options) {
  if (!options.freedom.from.empty() || options.cut_sets || !options.report.empty()) {
    throw base::InputError(options.model +
                           ": --from, --cut-sets and --report apply to plants, but this is a model program");
  }
  if (options.freedom.dense) {
    throw base::InputError(options.model + ": a model program moves in steps; give the duration of a step with --time");
  }
}

}  // namespace

ExitStatus check_model(const automata::ModelProgram& program, const PropertyOptions& options, const Common& common,
                       const std::string& title, const FormulaAsked& asked) {
  refuse_what_is_of_plants(options);
  const automata::Ticks step = options.freedom.period.value_or(automata::Ticks::of_seconds(1));
  check_window(asked.window, step);
  const verifier::MarkingQuestion question{.kind = asked.kind,
                                           .formula = formula_option(asked.formula, program, asked.option, common),
                                           .window = asked.window,
                                           .period = step,
                                           .commands = options.commands,
                                           .improbable = options.freedom.faults,
                                           .fewest_improbable = options.fewest_faults,
                                           .entailed = options.freedom.entailed,
                                           .bounds = options.budget.bounds()};
  if (common.verbose) {
    tell("checking " + title + " of " + program.name + ": " + std::to_string(program.locations.size()) +
         " locations, " + std::to_string(program.controls.size()) + " controls");
  }
  const verifier::MarkingAnswer answer = verifier::check(program, question, limits(options.budget, common));
  if (answer.startless) refuse_start(program, options.model);
  print_answer(
      common,
      [&] {
        return verifier::to_text(program, question, answer, output_painter(common.color).color) +
               (options.statistics ? verifier::statistics_text(answer.progress) : "");
      },
      [&] { return verifier::to_json(program, question, answer); },
      [&] { return verifier::to_junit(program, question, answer, title); });
  return status_of(answer.verdict);
}

}  // namespace rmpl::tools
