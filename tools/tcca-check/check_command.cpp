// tcca-check check.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <memory>
#include <set>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/output_file.hpp"
#include "compiler/lint/allowances.hpp"
#include "grammar/source/render.hpp"
#include "runtime/report/coverage.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/property_subject.hpp"
#include "tools/shared/suggestion.hpp"
#include "tools/tcca-check/check_options.hpp"
#include "tools/tcca-check/commands.hpp"
#include "tools/tcca-check/witness_flight.hpp"
#include "verifier/claims/stated_claims.hpp"
#include "verifier/closed_loop/check_all.hpp"
#include "verifier/verdict/table.hpp"

namespace rmpl::tools {

using automata::PlantProperty;
using verifier::Subject;

namespace {

struct QuestionOptions {
  std::string model;
  std::string properties;         ///< a path, or `-`
  std::string program;            ///< a path; empty: none but what the model has
  std::string entry;              ///< the definition to start with; empty: the one that no other calls
  std::vector<std::string> only;  ///< the names of those to check; empty: all
  Budget budget;
  bool statistics = false;
  std::string report;    ///< where to write a page to look at traces; empty: nowhere
  std::string coverage;  ///< where to write what traces come to; empty: nowhere
  unsigned jobs = 1;     ///< searches at a time
};

/// The properties that were asked for, and where they are stated.
struct ReadProperties {
  std::vector<PlantProperty> all;
  std::vector<Stated> stated;  ///< of those that a search decides
};

compiler::CompiledProperties compiled_properties(const QuestionOptions& options, const Common& common,
                                                 const Subject& subject, bool under_program) {
  auto compiled = compiler::compile_properties(options.properties, subject.plant, under_program);
  tell_findings(compiled.findings, common);
  if (!compiled.properties) throw Rejected{grammar::render_text(compiled.findings, false)};
  return compiled;
}

ReadProperties read_properties(const QuestionOptions& options, const Common& common, const Subject& subject) {
  // A claim on a program that is not asked for needs none.
  const bool under_program = subject.program != nullptr;
  auto compiled = compiled_properties(options, common, subject, under_program || !options.only.empty());
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
    const auto of_program = [](const PlantProperty& p) { return p.of_program; };
    if (!under_program && std::any_of(all.begin(), all.end(), of_program)) {
      compiled_properties(options, common, subject, under_program);
    }
  }
  grammar::Diagnostics wrong;  // lint tells what is wrong with a comment
  std::set<std::uint32_t> lines;
  for (const compiler::Allowance& one : compiler::allowances_in(compiled.findings.sources, 0, wrong)) {
    if (one.code == grammar::Code::vacuous_property) lines.insert(one.line);
  }
  ReadProperties result{std::move(all), {}};
  for (const PlantProperty& property : result.all) {
    if (verifier::is_measured(property)) continue;
    result.stated.push_back({property.name, property.origin, lines.contains(property.origin.line)});
  }
  return result;
}

/// The program of the claims on one: that of the command line, or the one that comes with the plant; none where there
/// is none, or where it could be any of several.
const automata::Program* program_of(const automata::Document& document, const QuestionOptions& options,
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

/// What the traces come to, each a run, of all that there is.
std::string coverage_of(const Subject& subject, const std::vector<runtime::Flight>& runs) {
  std::vector<runtime::CoverageItem> items = runtime::Coverage(&subject.plant, subject.program).items();
  for (const runtime::Flight& run : runs) {
    runtime::Coverage coverage(&subject.plant, subject.program);
    coverage.follow(run);
    runtime::add(items, coverage.items());
  }
  return runtime::to_json(items);
}

/// A file of properties alone is asked of what the project has for it.
void take_subject(QuestionOptions& options, const Settings& settings) {
  if (!options.properties.empty()) return;
  if (!options.model.ends_with(".props")) {
    throw base::InputError("PROPERTIES is missing: the claims about " + options.model + ", a .props file");
  }
  options.properties = std::move(options.model);
  if (!settings.manifest) {
    throw base::InputError(
        options.properties +
        ": properties refer to a plant; give the plant before the property file, or name both in an rmpl.toml");
  }
  PropertySubject subject = subject_of(*settings.manifest, options.properties);
  options.model = std::move(subject.plant);
  options.program = std::move(subject.program);
  if (options.entry.empty()) options.entry = std::move(subject.main);
}

ExitStatus run(const QuestionOptions& options, const Common& common) {
  check_standard_input({options.model, options.properties});
  std::vector<std::string> models = {options.model};
  if (!options.program.empty()) models.push_back(options.program);
  const compiler::Compilation compilation = load(models, common, {.main = options.entry, .model_is_plant = true});
  const automata::Document& document = compilation.document();
  const std::string paths = options.model + (options.program.empty() ? "" : ", " + options.program);
  const automata::Plant& plant = only_plant(document, paths);
  const Subject subject{plant, program_of(document, options, paths)};
  auto [stated, places] = read_properties(options, common, subject);
  const verifier::StatedClaims asked(subject, std::move(stated), options.budget.bounds());
  const std::vector<verifier::Question>& questions = asked.questions();
  TraceReport report(options.report, subject);
  std::optional<base::OutputFile> coverage;
  if (!options.coverage.empty()) coverage.emplace(options.coverage);
  verifier::Slices slices(plant);
  auto warnings = warn_of_questions(questions, slices, subject.program, common, places);
  std::vector<verifier::Answer> answers =
      verifier::check_all(subject, slices, questions, limits(options.budget, common), options.jobs);
  warn_of_answers(questions, std::move(warnings), answers, slices, common, places);
  const std::vector<verifier::Claim> claims = asked.with(std::move(answers), limits(options.budget, common));
  print_answer(
      common,
      [&] { return verifier::to_table(subject, claims, options.statistics, output_painter(common.color).color); },
      [&] { return verifier::to_json(subject, claims); }, [&] { return verifier::to_junit(subject, claims); });
  if (coverage) {
    coverage->write(coverage_of(subject, runs_of(subject, claims)));
    coverage->keep();
  }
  report.write(runs_of(subject, claims), subject, common.quiet);
  const verifier::Count found = verifier::count(claims);
  if (found.unexpected > 0) return ExitStatus::violated;
  return found.undecided > 0 ? ExitStatus::undecided : ExitStatus::done;
}

constexpr const char* check_notes =
    R"(Exit status: 0 all are as the file expects, 1 one is not, 2 the command line or an input is wrong, 3 one is undecided:
a limit or a signal ended the search, 4 an internal error, and nothing is claimed.)";

}  // namespace

void add_check(Program& program) {
  Command command = program.add_command("check", "check the properties in a file; the answer is a table of verdicts");
  const auto options = std::make_shared<QuestionOptions>();
  add_model(command, options->model);
  command.option("MODEL").description(
      "the plant: .tcca or compiled .json; - for standard input; not needed if an rmpl.toml names the property file");
  command.add_option("PROPERTIES", options->properties, "the claims: .props; - for standard input");
  command.add_option("PROGRAM", options->program, "the program that the claims are about: .rmpl or compiled .json");
  add_text(command, "--main", options->entry, "NAME",
           "the definition to start with (default: the one that no other definition calls)");
  add_texts(command, "--only", options->only, "NAME", "check this property alone; may be given several times");
  add_report(command, options->report);
  add_text(command, "--coverage", options->coverage, "OUT.json",
           "write which modes, transitions, faults and program locations the traces reach");
  add_budget(command, options->budget);
  constexpr std::uint64_t most_jobs = 256;
  add_whole_number(command, "--jobs,-j", options->jobs, 1, most_jobs,
                   "how many searches run at once (default: 1); verdicts are the same for any number");
  add_answer_form(command, program.common(), options->statistics);
  command.footer(check_notes);
  program.add({command,
               [options, &program] {
                 take_subject(*options, program.settings());
                 return run(*options, program.common());
               },
               AtSignal::tell});
}

}  // namespace rmpl::tools
