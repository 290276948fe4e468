// tcca-check program.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/stale_file.hpp"
#include "tools/tcca-check/commands.hpp"
#include "tools/tcca-check/program_options.hpp"
#include "tools/tcca-check/rehearsal.hpp"
#include "tools/tcca-check/witness_flight.hpp"
#include "verifier/closed_loop/check.hpp"
#include "verifier/closed_loop/each_fault.hpp"
#include "verifier/export/witness_scenario.hpp"
#include "verifier/verdict/report.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::tools {
namespace {

using verifier::Answer;
using verifier::CheckOptions;
using verifier::FaultOutcome;
using verifier::FaultTable;
using verifier::ProgramProperty;
using verifier::Property;
using verifier::ScenarioFrame;
using verifier::Subject;
using Kind = ProgramProperty::Kind;

/// Whether what violates it is there at one time, so that there is a soonest.
bool is_at_a_moment(Kind kind) {
  return kind != Kind::termination && kind != Kind::stuck && kind != Kind::eventually && kind != Kind::response;
}

/// What is to come in time, and what is owed in time.
void add_timed(const automata::Plant& plant, const ProgramOptions& options, const Common& common,
               std::vector<ProgramProperty>& result) {
  const TimedFormula within = options.within.value_or(TimedFormula{});
  bool taken = false;
  for (const TimedFormula& promise : options.eventuallys) {
    const bool own = promise.time.has_value();
    taken = taken || !own;
    const auto time = own ? promise.time : within.time;
    if (!time) throw base::InputError("--eventually: expected 'FORMULA within T', or a time in --within");
    if (!own && !within.formula.empty()) {
      throw base::InputError("--within: '" + within.formula + "' follows the time limit of --eventually");
    }
    result.push_back(ProgramProperty{Kind::eventually,
                                     program_formula_option(promise.formula, plant, "--eventually", common), *time,
                                     promise.formula});
  }
  for (const TimedResponse& response : options.responses) {
    const bool own = response.then.time.has_value();
    taken = taken || !own;
    const TimedFormula& then = own ? response.then : within;
    if (!then.time || then.formula.empty()) {
      throw base::InputError("--after: expected 'FORMULA within T FORMULA', or a time and a formula in --within");
    }
    result.push_back(ProgramProperty{.kind = Kind::response,
                                     .formula = program_formula_option(response.asks, plant, "--after", common),
                                     .within = *then.time,
                                     .text = response.asks,
                                     .then = program_formula_option(then.formula, plant, "--after", common),
                                     .then_text = then.formula});
  }
  if (options.within && !taken) {
    throw base::InputError(options.eventuallys.empty() && options.responses.empty()
                               ? "--within: use it with --eventually or --after"
                               : "--within: each --eventually and --after already has its own time");
  }
}

/// What is asked by its name.
std::vector<ProgramProperty> asked_of(const automata::Plant& plant, const ProgramOptions& options,
                                      const Common& common) {
  std::vector<ProgramProperty> result;
  for (const GeneralCheck& check : options.general) {
    if (check.kind == Kind::stuck && options.allow_stuck) {
      if (check.of_all) continue;
      throw base::InputError("--allow-stuck contradicts --check stuck");
    }
    result.push_back(ProgramProperty{.kind = check.kind, .warning = check.of_all && check.kind == Kind::undone});
  }
  for (const std::string& text : options.nevers) {
    ProgramProperty never{Kind::never, program_formula_option(text, plant, "--never", common), {}, text};
    never.window = options.window.window;
    result.push_back(std::move(never));
  }
  add_timed(plant, options, common, result);
  for (const std::string& text : options.finallys) {
    result.push_back(
        ProgramProperty{Kind::finally, program_formula_option(text, plant, "--finally", common), {}, text});
  }
  return result;
}

/// What is asked; where nothing is, the properties that every program should have. Whether runs get stuck is asked
/// along with all else, as no other verdict says anything of what would follow. Throws base::InputError where an option
/// has no meaning for one of them.
std::vector<Property> properties_of(const automata::Plant& plant, const ProgramOptions& options, const Common& common) {
  std::vector<ProgramProperty> asked = asked_of(plant, options, common);
  for (const ProgramProperty& property : asked) {
    if (!options.window.fastest || is_at_a_moment(property.kind)) continue;
    throw base::InputError(
        "--fastest: " + std::string(name_of(property.kind)) +
        " is violated if something never happens, so a violation has no time; use it without --fastest");
  }
  if (asked.empty() && !options.each_fault) {
    for (const Kind kind : verifier::general_kinds) {
      if (kind == Kind::stuck && options.allow_stuck) continue;
      asked.push_back({.kind = kind, .warning = kind == Kind::undone});
    }
  }
  const bool asks = std::any_of(asked.begin(), asked.end(), [](const auto& p) { return p.kind == Kind::stuck; });
  if (!asks && !options.allow_stuck && !options.each_fault) asked.push_back({.kind = Kind::stuck});
  std::vector<Property> result;
  for (ProgramProperty& property : asked) {
    if (options.cut_sets && property.kind == Kind::termination) {
      throw base::InputError(
          "--cut-sets: termination has no cut sets, because a run without end leads to no final state; name other "
          "checks, such as --check endless-wait");
    }
    const bool some_day = property.within.is_infinite();
    if (options.cut_sets && some_day) throw base::InputError(no_cut_sets_of_some_day);
    property.fastest = options.window.fastest && is_at_a_moment(property.kind);
    result.emplace_back(std::move(property));
  }
  return result;
}

ExitStatus print_table(const Subject& subject, const verifier::ProgramQuestion& question, const FaultTable& table,
                       const ProgramOptions& options, const Common& common) {
  print_answer(
      common,
      [&] {
        return verifier::to_text(subject, table) +
               (options.statistics ? verifier::statistics_text(table.progress) : "");
      },
      [&] { return verifier::to_json(subject, question, table); }, [&] { return verifier::to_junit(subject, table); });
  if (std::any_of(table.rows.begin(), table.rows.end(), [](const FaultOutcome& row) { return row.fails(); })) {
    return ExitStatus::violated;
  }
  return table.limit ? ExitStatus::undecided : ExitStatus::done;
}

/// Where the scenario goes, and what it calls its program and plant. Throws base::InputError before anything is
/// searched.
ScenarioFrame frame_of(const ProgramOptions& options, const Subject& subject) {
  namespace fs = std::filesystem;
  ScenarioFrame frame{{}, {}, {}, options.entry, options.freedom.period.value_or(options.cycle)};
  const fs::path folder = fs::absolute(options.scenario).lexically_normal().parent_path();
  for (const std::string& model : options.models()) {
    const fs::path path = fs::absolute(model).lexically_normal();
    const std::string extension = path.extension().string();
    if (extension != ".rmpl" && extension != ".tcca") {
      throw base::InputError(model + ": a scenario refers to source files; give a .rmpl file, and the plant's");
    }
    const bool first = frame.program.empty() && extension == ".rmpl";
    (first ? frame.program : frame.plant) = path.lexically_proximate(folder).string();
  }
  frame.name = verifier::title(subject);
  return frame;
}

/// Writes the first violation that a flight shows as a scenario, to `path`: false where there is none. One of dense
/// time is looked for again in cycles. It is kept by the caller, once nothing else can fail.
bool write_scenario(const std::string& path, base::OutputFile& file, const ScenarioFrame& frame, const Subject& subject,
                    automata::PlantStep& step, const std::vector<Property>& properties,
                    const std::vector<Answer>& answers, const CheckOptions& free, const Common& common,
                    const verifier::Limits& limits) {
  std::optional<std::string> why;
  for (std::size_t p = 0; p < properties.size(); ++p) {
    if (!answers[p].witness || verifier::is_warning(properties[p])) continue;
    Answer answer = answers[p];
    if (!free.period && !answer.witness->stop) {
      CheckOptions sampled = free;
      sampled.period = frame.cycle;
      answer = verifier::check(*subject.program, step, {properties[p]}, sampled, limits).front();
    }
    const auto& witness = answer.witness;
    const auto& property = std::get<ProgramProperty>(properties[p]);
    const std::string not_found = "in cycles of " + automata::format_seconds(frame.cycle) +
                                  " s the violation was not found" +
                                  (answer.limit ? " before the search ended" : "; --cycle takes another length");
    auto refused = witness ? verifier::no_scenario(step, property, *witness) : std::optional(not_found);
    if (!refused) {
      // Where the estimate comes to what the trace has it may take its time.
      constexpr std::int64_t most_patience = 100'000;
      ScenarioFrame patient = frame;
      do {
        const std::string text = verifier::scenario_text(step, property, *witness, patient);
        refused = rehearse(path, text, subject.plant, property, *witness, limits.interrupted);
        if (!refused) {
          file.write(text);
          return true;
        }
        patient.patience *= 8;
      } while (verifier::is_about_patience(property) && patient.patience < most_patience);
    }
    if (!why) why = refused;
  }
  if (why) {
    tell("warning: no scenario is written: " + *why);
  } else if (!common.quiet) {
    tell("no property is violated, so no scenario is written");
  }
  return false;
}

std::string text_of(const Subject& subject, const std::vector<Property>& properties, const CheckOptions& free,
                    const std::vector<Answer>& answers, const ProgramOptions& options, const Common& common) {
  std::string text;
  for (std::size_t p = 0; p < properties.size(); ++p) {
    text += verifier::to_text(subject, {properties[p], free}, answers[p], output_painter(common.color).color);
  }
  return text + (options.statistics ? verifier::statistics_text(answers.back().progress) : "");
}

std::vector<verifier::Question> questions_of(const std::vector<Property>& properties, const CheckOptions& free) {
  std::vector<verifier::Question> result;
  result.reserve(properties.size());
  for (const Property& property : properties) result.push_back({property, free});
  return result;
}

ExitStatus run_table(const ProgramOptions& options, const Common& common, const Subject& subject,
                     automata::PlantStep& step, const std::vector<Property>& properties, const CheckOptions& free) {
  TraceReport report(options.report, subject);
  verifier::Slices slices(subject.plant);
  CheckOptions with_one = free;
  with_one.faults = 1;
  const auto warnings = warn_of_questions(questions_of(properties, with_one), slices, subject.program, common);
  FaultTable table =
      verifier::check_each_fault(*subject.program, step, properties, free, limits(options.budget, common));
  for (const auto& one : warnings) table.warnings.insert(table.warnings.end(), one.begin(), one.end());
  report.write(flights_of(subject, table, free.period), subject, common.quiet);
  return print_table(subject, {properties, free, options.budget.bounds()}, table, options, common);
}

ExitStatus run_check(const ProgramOptions& options, const Common& common, const Subject& subject,
                     automata::PlantStep& step, const std::vector<Property>& properties, const CheckOptions& free) {
  verifier::Slices slices(subject.plant);
  const std::vector<verifier::Question> questions = questions_of(properties, free);
  auto warnings = warn_of_questions(questions, slices, subject.program, common);
  std::optional<ScenarioFrame> frame;
  std::optional<base::OutputFile> file;
  if (!options.scenario.empty()) {
    frame = frame_of(options, subject);
    file.emplace(options.scenario);  // before the search: a name that cannot be written is told at once
  }
  TraceReport report(options.report, subject);
  const verifier::Limits bounds = limits(options.budget, common);
  std::vector<Answer> answers = verifier::check(*subject.program, step, properties, free, bounds);
  const verifier::ProgramQuestion question{properties, free, options.budget.bounds()};
  warn_of_answers(questions, std::move(warnings), answers, slices, common);
  print_answer(
      common, [&] { return text_of(subject, properties, free, answers, options, common); },
      [&] { return verifier::to_json(subject, question, answers); },
      [&] { return verifier::to_junit(subject, question, answers); });
  const bool shown = frame && write_scenario(options.scenario, *file, *frame, subject, step, properties, answers, free,
                                             common, bounds);
  std::vector<runtime::Flight> flights;
  for (std::size_t p = 0; p < properties.size(); ++p) {
    auto own = flights_of(subject, verifier::name_of(properties[p]), properties[p], free, answers[p]);
    std::move(own.begin(), own.end(), std::back_inserter(flights));
  }
  report.write(std::move(flights), subject, common.quiet);
  if (shown) file->keep();
  if (frame && !shown) remove_stale(options.scenario);
  return status_of(verifier::overall(properties, answers));
}

ExitStatus run(const ProgramOptions& options, const Common& common) {
  check_window(options.window.window, options.freedom.period);
  const compiler::Compilation compilation =
      load(options.models(), common, {.main = options.entry, .model_is_plant = true});
  const automata::Document& document = compilation.document();
  const std::string paths = options.plant.empty() ? options.program : options.program + ", " + options.plant;
  const automata::Program& program = only_program(document, paths);
  const automata::Plant& plant = only_plant(document, paths);
  const Subject subject{plant, &program};
  const std::vector<Property> properties = properties_of(plant, options, common);
  const Freedom& freedom = options.freedom;
  const CheckOptions free{.period = freedom.period,
                          .faults = options.cut_sets ? *options.cut_sets : freedom.faults.value_or(0),
                          .entailed = freedom.entailed,
                          .fewest_faults = options.fewest_faults,
                          .cut_sets = options.cut_sets.has_value(),
                          .from = assignments_option(freedom.from, plant, "--from", common)};
  automata::PlantStep step(plant);
  return (options.each_fault ? run_table : run_check)(options, common, subject, step, properties, free);
}

}  // namespace

void add_program(Program& program) {
  Command command =
      program.add_command("program", "check a program that controls a plant; each violation comes with a timed trace");
  const auto options = std::make_shared<ProgramOptions>();
  add_program_options(command, *options, program.common());
  program.add({command, [options, &common = program.common()] { return run(*options, common); }, AtSignal::tell});
}

}  // namespace rmpl::tools
