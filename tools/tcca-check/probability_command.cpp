// tcca-check probability.
// SPDX-License-Identifier: MIT
#include <memory>

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "tools/shared/models.hpp"
#include "tools/tcca-check/check_options.hpp"
#include "tools/tcca-check/commands.hpp"
#include "verifier/claims/probability_claim.hpp"
#include "verifier/markov/report.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::tools {
namespace {

struct ProbabilityOptions {
  std::string model, plant, entry;
  std::string target;
  std::optional<automata::Ticks> within;
  Freedom freedom;
  verifier::Commands commands = verifier::Commands::one;
  bool min = false, max = false;
  std::string curve;
  std::optional<std::size_t> points;
  bool mean_time = false;
  double precision = 1e-6;
  Budget budget;
  bool statistics = false;
};

constexpr std::size_t default_points = 101;

verifier::ProbabilityQuestion question_of(const ProbabilityOptions& options, const automata::Plant& plant,
                                          const Common& common) {
  const Freedom& freedom = options.freedom;
  verifier::ProbabilityQuestion question{.target = formula_option(options.target, plant, "--target", common),
                                         .entailed = freedom.entailed,
                                         .period = freedom.period,
                                         .within = options.within,
                                         .faults = freedom.faults,
                                         .commands = options.commands,
                                         .from = assignments_option(freedom.from, plant, "--from", common),
                                         .mean_time = options.mean_time,
                                         .precision = options.precision};
  if (options.within && options.within->is_infinite()) question.within.reset();
  if (options.min != options.max) {
    question.least = options.min;
    question.greatest = options.max;
  }
  if (options.mean_time && freedom.faults) {
    throw base::InputError("--mean-time averages over all runs, but --faults excludes some; use one of them");
  }
  if (options.curve.empty()) return question;
  if (!question.within) throw base::InputError("--curve needs a finite end: give --within T");
  question.points = options.points.value_or(default_points);
  return question;
}

void write_curve(const ProbabilityOptions& options, const verifier::ProbabilityAnswer& answer) {
  const bool svg = options.curve.ends_with(".svg");
  base::write_file(options.curve, svg ? verifier::curve_svg(answer, options.target) : verifier::curve_csv(answer));
}

ExitStatus run(const ProbabilityOptions& options, const Common& common) {
  const std::vector<std::string> paths =
      options.plant.empty() ? std::vector{options.model} : std::vector{options.model, options.plant};
  const std::string named = options.plant.empty() ? options.model : options.model + ", " + options.plant;
  if (!options.curve.empty() && !options.curve.ends_with(".svg") && !options.curve.ends_with(".csv")) {
    throw base::InputError("--curve " + options.curve + ": expected a name that ends in .csv or .svg");
  }
  const compiler::Compilation compilation = load(paths, common, {.main = options.entry, .model_is_plant = true});
  const automata::Document& document = compilation.document();
  const automata::Plant& plant = only_plant(document, named);
  const bool closed = !options.plant.empty() || !document.programs.empty();
  const verifier::ProbabilityQuestion question = question_of(options, plant, common);
  if (closed && (options.min || options.max)) {
    throw base::InputError("--min and --max apply to free commands, but here the program chooses the commands");
  }
  const verifier::ProbabilityAnswer answer = verifier::probability_of(
      {plant, closed ? &only_program(document, named) : nullptr}, question, limits(options.budget, common));
  if (!options.curve.empty() && !answer.limit) write_curve(options, answer);
  print_answer(
      common,
      [&] {
        return verifier::to_text(question, answer, options.target) +
               (options.statistics ? verifier::statistics_text(answer.progress) : "");
      },
      [&] { return verifier::to_json(question, answer, options.target); },
      []() -> std::string { throw base::InputError("--format junit is for verdicts; expected text or json"); });
  return answer.limit || !answer.precise ? ExitStatus::undecided : ExitStatus::done;
}

double precision(const std::string& text) {
  const std::optional<double> value = real_number(text);
  if (!value || !(*value >= 1e-12) || !(*value <= 1)) {
    throw BadValue("expected a number from 1e-12 to 1, not '" + text + "'");
  }
  return *value;
}

constexpr const char* probability_notes =
    R"(Exit status: 0 the bounds are as close as was asked, 2 the command line or an input is wrong, 3 undecided: a limit or
a signal ended it, or the bounds stay apart, 4 an internal error, and nothing is claimed.)";

}  // namespace

void add_probability(Program& program) {
  Command command =
      program.add_command("probability", "how likely is it that a formula becomes true? with guaranteed bounds");
  const auto options = std::make_shared<ProbabilityOptions>();
  command.add_option("MODEL", options->model, "the plant, or a program before its plant").required();
  command.add_option("PLANT", options->plant, "the plant of the program");
  add_text(command, "--main", options->entry, "NAME",
           "the definition to start with (default: the one that no other definition calls)");
  add_text(command, "--target", options->target, "FORMULA", "the formula that becomes true").required();
  add_read(command, "--within", options->within, duration, "by when, from the start; inf, the default: ever")
      .option_text("T");
  Option least = command.add_flag("--min", options->min, "with free commands: only the least probability");
  Option greatest = command.add_flag("--max", options->max, "with free commands: only the greatest probability");
  least.excludes(greatest);
  Option curve = add_text(command, "--curve", options->curve, "OUT.csv|OUT.svg",
                          "write the probability over time, from 0 to --within");
  constexpr std::uint64_t most_points = 100'000;
  add_whole_number(command, "--points", options->points, 2, most_points, "how many points it has (default: 101)")
      .needs(curve);
  command.add_flag("--mean-time", options->mean_time, "also compute the mean time until it holds");
  add_read(command, "--precision", options->precision, precision,
           "the largest relative gap between the bounds (default: 1e-6)")
      .option_text("P");
  add_freedom(command, options->freedom);
  command.option("--faults").description("do not follow runs with more faults; the bounds include what they could add");
  add_commands(command, options->commands);
  add_budget(command, options->budget);
  add_answer_form(command, program.common(), options->statistics);
  command.footer(probability_notes);
  program.add({command, [options, &common = program.common()] { return run(*options, common); }, AtSignal::tell});
}

}  // namespace rmpl::tools
