// tcca-check check.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <memory>

#include "base/check.hpp"
#include "base/error.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/suggestion.hpp"
#include "tools/tcca-check/check_options.hpp"
#include "tools/tcca-check/commands.hpp"
#include "tools/tcca-check/witness_flight.hpp"
#include "verifier/closed_loop/check_all.hpp"
#include "verifier/verdict/table.hpp"

namespace rmpl::tools {

using automata::PlantProperty;
using verifier::Commands;
using verifier::ProgramProperty;
using verifier::Subject;

namespace {

struct Options {
  std::string model;
  std::string properties;         ///< a path, or `-`
  std::string program;            ///< a path; empty: none but what the model has
  std::string entry;              ///< the definition to start with; empty: the one that no other calls
  std::vector<std::string> only;  ///< the names of those to check; empty: all
  Budget budget;
  bool statistics = false;
  std::string report;  ///< where to write a page to look at traces; empty: nowhere
};

Commands commands_of(PlantProperty::Commands commands) {
  switch (commands) {
    case PlantProperty::Commands::none:
      return Commands::none;
    case PlantProperty::Commands::one:
      return Commands::one;
    case PlantProperty::Commands::any:
      return Commands::any;
  }
  return Commands::one;
}

ProgramProperty::Kind kind_of(PlantProperty::Claim claim) {
  using Claim = PlantProperty::Claim;
  using Kind = ProgramProperty::Kind;
  switch (claim) {
    case Claim::never:
      return Kind::never;
    case Claim::response:
      return Kind::response;
    case Claim::eventually:
      return Kind::eventually;
    case Claim::finally:
      return Kind::finally;
    case Claim::stuck:
      return Kind::stuck;
    case Claim::goal_conflict:
      return Kind::goal_conflict;
    case Claim::no_plan:
      return Kind::no_plan;
    case Claim::endless_wait:
      return Kind::endless_wait;
    case Claim::termination:
      return Kind::termination;
    case Claim::undone:
      return Kind::undone;
    case Claim::reach:
      break;
  }
  throw base::InternalError("what can be reached is asked of a plant alone");
}

verifier::Property property_of(const PlantProperty& stated, const automata::Plant& plant) {
  if (stated.of_program) {
    ProgramProperty asked{.kind = kind_of(stated.claim)};
    const auto text = [&](const automata::Formula& formula) {
      return formula == automata::constant(true) ? "" : to_text(formula, plant.variables);
    };
    asked.formula = stated.formula;
    asked.within = stated.within;
    asked.text = text(stated.formula);
    asked.then = stated.then;
    asked.then_text = text(stated.then);
    return asked;
  }
  switch (stated.claim) {
    case PlantProperty::Claim::never:
      return verifier::Safety{stated.formula, {}, false};
    case PlantProperty::Claim::reach:
      return verifier::Reachability{stated.formula, {}, false};
    case PlantProperty::Claim::stuck:
      return verifier::Stuck{};
    default:
      return verifier::Response{stated.formula, stated.then, stated.within};
  }
}

std::vector<PlantProperty> read_properties(const Options& options, const Common& common, const Subject& subject) {
  auto compiled = compiler::compile_properties(options.properties, subject.plant, subject.program != nullptr);
  tell_findings(compiled.findings, common);
  if (!compiled.properties) throw Rejected{};
  std::vector<PlantProperty> all = std::move(*compiled.properties);
  std::vector<std::string_view> names;
  names.reserve(all.size());
  for (const PlantProperty& property : all) names.emplace_back(property.name);
  for (const std::string& name : options.only) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw base::InputError("--only: " + options.properties + " has no property '" + name + "'" +
                             suggestion_or_list(name, names));
    }
  }
  if (!options.only.empty()) {
    std::erase_if(all, [&](const auto& p) {
      return std::find(options.only.begin(), options.only.end(), p.name) == options.only.end();
    });
  }
  return all;
}

std::vector<verifier::Question> questions_of(const std::vector<PlantProperty>& stated, const automata::Plant& plant,
                                             const Options& options) {
  std::vector<verifier::Question> questions;
  questions.reserve(stated.size());
  for (const PlantProperty& p : stated) {
    questions.push_back({property_of(p, plant),
                         {.period = p.period,
                          .faults = p.faults,
                          .commands = commands_of(p.commands),
                          .entailed = p.entailed,
                          .from = p.from},
                         options.budget.bounds()});
  }
  return questions;
}

/// The program of the claims on one: that of the command line, or the one that comes with the plant; none where there
/// is none, or where it could be any of several.
const automata::Program* program_of(const automata::Document& document, const Options& options,
                                    const std::string& paths) {
  if (!options.program.empty()) return &only_program(document, paths);
  return document.programs.size() == 1 ? &document.programs.front() : nullptr;
}

/// The runs of all claims; a claim on the plant alone is shown under the program too, which marks nothing there.
std::vector<runtime::Flight> runs_of(const Subject& subject, const std::vector<verifier::Claim>& claims) {
  std::vector<runtime::Flight> flights;
  for (const verifier::Claim& claim : claims) {
    auto own = flights_of(subject, claim.name, claim.question.property, claim.question.options, claim.answer);
    std::move(own.begin(), own.end(), std::back_inserter(flights));
  }
  return flights;
}

ExitStatus run(const Options& options, const Common& common) {
  check_standard_input({options.model, options.properties});
  std::vector<std::string> models = {options.model};
  if (!options.program.empty()) models.push_back(options.program);
  const compiler::Compilation compilation = load(models, common, {options.entry});
  const automata::Document& document = compilation.document();
  const std::string paths = options.model + (options.program.empty() ? "" : ", " + options.program);
  const automata::Plant& plant = only_plant(document, paths);
  const Subject subject{plant, program_of(document, options, paths)};
  const std::vector<PlantProperty> stated = read_properties(options, common, subject);
  std::vector<verifier::Question> questions = questions_of(stated, plant, options);
  TraceReport report(options.report, subject);
  verifier::Slices slices(plant);
  auto warnings = warn_of_questions(questions, slices, common);
  std::vector<verifier::Answer> answers =
      verifier::check_all(subject, slices, questions, limits(options.budget, common));
  warn_of_answers(questions, std::move(warnings), answers, slices, common);
  std::vector<verifier::Claim> claims;
  for (std::size_t q = 0; q < stated.size(); ++q) {
    claims.push_back({stated[q].name, std::move(questions[q]), stated[q].expect_violated, std::move(answers[q])});
  }
  print_answer(
      common,
      [&] { return verifier::to_table(subject, claims, options.statistics, output_painter(common.color).color); },
      [&] { return verifier::to_json(subject, claims); }, [&] { return verifier::to_junit(subject, claims); });
  report.write(runs_of(subject, claims), subject, common.quiet);
  const verifier::Count found = verifier::count(claims);
  if (found.unexpected > 0) return ExitStatus::violated;
  return found.undecided > 0 ? ExitStatus::undecided : ExitStatus::done;
}

}  // namespace

void add_check(Program& program) {
  CLI::App* command =
      program.app().add_subcommand("check", "do all properties of a file come out as it expects? a table of verdicts");
  const auto options = std::make_shared<Options>();
  add_model(*command, options->model);
  command->add_option("PROPERTIES", options->properties, "what is claimed of it: .props; - for standard input")
      ->required();
  command->add_option("PROGRAM", options->program, "the program that is spoken of: .rmpl or compiled .json");
  add_text(*command, "--main", options->entry, "NAME",
           "the definition to start with; else the one that no other calls");
  add_texts(*command, "--only", options->only, "NAME", "check this property alone; may be given several times");
  add_report(*command, options->report);
  add_budget(*command, options->budget);
  add_format(*command, program.common(), true);
  command->add_flag("--stats", options->statistics, "tell what each search has cost; properties may share one");
  program.add({command, [options, &common = program.common()] { return run(*options, common); }});
}

}  // namespace rmpl::tools
