// Checking one property of a plant.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/property_check.hpp"

#include <variant>

#include "base/error.hpp"
#include "tools/shared/models.hpp"
#include "tools/tcca-check/witness_flight.hpp"
#include "verifier/check/check.hpp"
#include "verifier/verdict/report.hpp"
#include "verifier/verdict/table.hpp"
#include "verifier/verdict/wording.hpp"
#include "verifier/zone/time_model.hpp"

namespace rmpl::tools {

using automata::Plant;

namespace {

/// `drawn`: any number of faults is allowed.
verifier::CheckOptions check_options(const Plant& plant, const PropertyOptions& options, const Common& common,
                                     bool drawn) {
  const Freedom& freedom = options.freedom;
  verifier::CheckOptions result{.period = period_of(freedom, plant),
                                .faults = freedom.faults.value_or(0),
                                .commands = options.commands,
                                .entailed = freedom.entailed,
                                .fewest_faults = options.fewest_faults,
                                .cut_sets = options.cut_sets.has_value(),
                                .symmetry = !options.no_symmetry,
                                .from = assignments_option(freedom.from, plant, "--from", common)};
  if (options.fewest_faults && !freedom.faults) result.faults.reset();
  if (!options.fewest_faults && !freedom.faults && drawn) result.faults = most_faults;
  if (options.cut_sets) result.faults = options.cut_sets;
  return result;
}

/// Which traces are wanted, where one is not as good as another.
void add_choice_of_traces(Command& command, PropertyOptions& options) {
  Option fewest = command.add_flag("--fewest-faults", options.fewest_faults,
                                   "find a trace with the fewest faults; --faults limits their number");
  constexpr std::uint64_t most = 1'000'000;
  add_whole_number(command, "--cut-sets", options.cut_sets, 0, most,
                   "find every minimal set of up to K faults that leads to a trace")
      .excludes(fewest)
      .excludes(command.option("--faults"));
}

}  // namespace

void add_property_options(Command& command, PropertyOptions& options, Common& common, Asked asked) {
  add_model(command, options.model, options.main);
  add_freedom(command, options.freedom, asked == Asked::formula);
  add_commands(command, options.commands);
  if (asked == Asked::formula) add_choice_of_traces(command, options);
  command.add_flag("--no-symmetry", options.no_symmetry,
                   "do not merge states that differ only in the names of identical components");
  add_report(command, options.report);
  add_budget(command, options.budget);
  add_answer_form(command, common, options.statistics);
}

void add_window(Command& command, WindowOptions& options) {
  add_read(command, "--not-before", options.window.not_before, duration, "consider the formula only from this time on")
      .option_text("T");
  const auto end = [](const std::string& text) {
    const automata::Ticks time = duration(text);
    return time.is_infinite() ? std::nullopt : std::optional(time);  // up to any time
  };
  add_read(command, "--by", options.window.by, end, "consider the formula only up to this time").option_text("T");
  command.add_flag("--fastest", options.fastest, "find the fastest trace, not the one with the fewest steps");
}

void check_window(const verifier::Window& window, std::optional<automata::Ticks> period) {
  if (window.not_before && window.not_before->is_infinite()) {
    throw base::InputError("--not-before inf: no time is that late");
  }
  if (!window.by) return;
  const automata::Ticks from = window.not_before.value_or(automata::Ticks{});
  const auto text = [](automata::Ticks time) { return automata::format_seconds(time) + " s"; };
  if (*window.by < from) {
    throw base::InputError("--by " + text(*window.by) + " is before --not-before " + text(from) +
                           ": no time is in the window");
  }
  if (!period) return;
  const automata::Ticks last{window.by->count - window.by->count % period->count};
  if (last < from) {
    throw base::InputError("no step of " + text(*period) + " ends from --not-before " + text(from) + " to --by " +
                           text(*window.by));
  }
}

std::optional<automata::Ticks> period_of(const Freedom& freedom, const Plant& plant) {
  return freedom.period || freedom.dense ? freedom.period : verifier::usual_period(plant);
}

ExitStatus check_property(const PropertyOptions& options, const Common& common, const std::string& title,
                          const std::function<verifier::Property(const Plant&)>& ask) {
  const compiler::Compilation compilation =
      load({options.model}, common, {.main = options.main, .model_is_plant = true});
  const Plant& plant = only_plant(compilation.document(), options.model);
  const verifier::Property asked = ask(plant);
  if (common.verbose) {
    tell("checking " + verifier::name_of(asked) + " of " + plant.name + ": " + std::to_string(plant.components.size()) +
         " components, " + std::to_string(plant.controls.size()) + " controls");
  }
  verifier::Slices slices(plant);
  const verifier::Subject subject{plant};
  TraceReport report(options.report, subject);
  // Every draw of a model program is free.
  const bool drawn = !compilation.document().models.empty() && (std::holds_alternative<verifier::Reachability>(asked) ||
                                                                std::holds_alternative<verifier::Safety>(asked));
  const std::vector<verifier::Question> questions{
      {asked, check_options(plant, options, common, drawn), options.budget.bounds()}};
  const verifier::Question& question = questions.front();
  auto warnings = warn_of_questions(questions, slices, nullptr, common);
  std::vector<verifier::Answer> answers{
      verifier::check(slices, asked, question.options, limits(options.budget, common))};
  warn_of_answers(questions, std::move(warnings), answers, slices, common);
  const verifier::Answer& answer = answers.front();
  print_answer(
      common,
      [&] {
        return verifier::to_text(subject, question, answer, output_painter(common.color).color) +
               (options.statistics ? verifier::statistics_text(answer.progress) : "");
      },
      [&] { return verifier::to_json(subject, question, answer); },
      [&] {
        return verifier::to_junit(subject, {{.name = title, .origin = {}, .question = question, .answer = answer}});
      });
  report.write(flights_of(subject, title, asked, question.options, answer), subject, common.quiet);
  return status_of(answer.verdict);
}

}  // namespace rmpl::tools
