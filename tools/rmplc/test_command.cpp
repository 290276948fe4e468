// rmplc test: all that a project holds is linted, flown and checked.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "tools/rmplc/commands.hpp"
#include "tools/rmplc/project/dependencies.hpp"
#include "tools/rmplc/project/report.hpp"
#include "tools/rmplc/project/run.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

namespace fs = std::filesystem;

enum class TestForm { text, json, junit, github, markdown };

struct TestOptions {
  std::string where;
  TestChoice choice;
  unsigned jobs = 1;
  TestForm form = TestForm::text;
  std::string junit, markdown, coverage, depfile;  ///< where to write it; empty: nowhere
};

constexpr const char* test_notes =
    R"(Reads the file rmpl.toml in DIR (here, where none is given) or a folder above it; see
rmpl.toml(5). Each set in it is compiled and linted, its scenarios are flown by
rmpl-run, and its properties are checked by tcca-check. A folder below that of
rmpl.toml, or a file, means what is in it alone, and no lint; so does --only. A
pattern of --only is as of the shell (* ? [a-z]) and matches a name, a file, or
'FILE: NAME'.

Behind the outcomes stands what no flight, and no trace of a property, came to: modes,
transitions, faults and primitive locations of the program.

Exit status: 0 all passed, 1 something was found or failed, 2 an input is wrong,
3 something is undecided: a limit, the time limit or an interruption came first,
4 a program failed.

Examples:
  rmplc test                          the project here
  rmplc test --only '*breaks*'        some scenarios and properties
  rmplc test --junit out.xml -j 4     for continuous integration
  rmplc test --format github --markdown "$GITHUB_STEP_SUMMARY")";

/// The manifest of what is meant, and how it is chosen from it.
Manifest manifest_of(const TestOptions& options, TestChoice& choice) {
  std::error_code error;
  const std::string where = options.where.empty() ? "." : options.where;
  if (!fs::exists(where, error)) throw base::InputError(where + ": there is no such folder or file");
  const auto path = find_manifest(where);
  if (!path) {
    throw base::InputError(where +
                           ": there is no rmpl.toml here or in a folder above; `rmplc new NAME` makes a project");
  }
  const fs::path folder = fs::path(*path).parent_path();
  const bool whole = fs::equivalent(where, folder.empty() ? "." : folder, error) || fs::equivalent(where, *path, error);
  if (!whole) choice.below = where;
  return read_manifest(*path, base::read_file(*path));
}

void print_answer(const ProjectOutcomes& outcomes, TestForm form, const Common& common) {
  switch (form) {
    case TestForm::json:
      return print_json(to_json(outcomes));
    case TestForm::junit:
      return print_file(to_junit(outcomes));
    case TestForm::github:
      return print(to_github(outcomes));
    case TestForm::markdown:
      return print(to_markdown(outcomes));
    case TestForm::text:
      break;
  }
  const TestDetail detail = common.quiet     ? TestDetail::failures
                            : common.verbose ? TestDetail::everything
                                             : TestDetail::usual;
  print(to_text(outcomes, detail, output_painter(common.color)));
}

ExitStatus run(const TestOptions& options, const Common& common) {
  TestChoice choice = options.choice;
  const Manifest manifest = manifest_of(options, choice);
  // Names that cannot be written are told before anything runs.
  std::optional<base::OutputFile> junit, markdown, coverage, depfile;
  if (!options.junit.empty()) junit.emplace(options.junit);
  if (!options.markdown.empty()) markdown.emplace(options.markdown);
  if (!options.coverage.empty()) coverage.emplace(options.coverage);
  if (!options.depfile.empty()) depfile.emplace(options.depfile);
  const TestPlan plan = plan_tests(manifest, choice);
  ProjectOutcomes outcomes = run_tests(plan, choice, find_settings(manifest.path), options.jobs);
  outcomes.project = manifest.name.empty() ? manifest.path : manifest.name;
  print_answer(outcomes, options.form, common);
  const auto keep = [](std::optional<base::OutputFile>& file, const std::string& text) {
    if (!file) return;
    file->write(text);
    file->keep();
  };
  keep(junit, to_junit(outcomes));
  keep(markdown, to_markdown(outcomes));
  keep(coverage, runtime::to_json(outcomes.coverage));
  keep(depfile, dependency_rule(options.junit, plan.files()));
  return outcomes.status();
}

}  // namespace

void add_test(Program& program) {
  Command command = program.add_command("test", "lint, fly and check a project");
  const auto options = std::make_shared<TestOptions>();
  command.add_option("DIR", options->where, "the folder of the project, one in it, or a file of it");
  command.add_option("--set", options->choice.sets, "test this set alone; may be given several times")
      .option_text("NAME")
      .repeatable();
  command
      .add_option("--only", options->choice.only, "run only tests that match the pattern; may be given several times")
      .option_text("PATTERN")
      .repeatable();
  command
      .add_option("--changed-since", options->choice.since,
                  "test only the sets that depend on files changed since this git revision")
      .option_text("REV");
  constexpr std::uint64_t most_jobs = 256;
  options->jobs = std::clamp(std::thread::hardware_concurrency(), 1u, static_cast<unsigned>(most_jobs));
  add_whole_number(command, "--jobs,-j", options->jobs, 1, most_jobs,
                   "how many tests run at once; the answer is the same for any number\n(default: one per core)");
  add_read(command, "--time-limit", options->choice.patience, positive_duration,
           "time limit of a scenario, or of a file of properties")
      .option_text("TIME");
  add_choice<TestForm>(command, "--format", options->form,
                       {{"text", TestForm::text},
                        {"json", TestForm::json},
                        {"junit", TestForm::junit},
                        {"github", TestForm::github},
                        {"markdown", TestForm::markdown}},
                       "the format of the answer (default: text)");
  Option junit =
      command.add_option("--junit", options->junit, "write a test case for each finding, expectation and property");
  junit.option_text("OUT.xml");
  command
      .add_option("--depfile", options->depfile,
                  "write the files that the --junit output depends on, for make and ninja")
      .option_text("OUT.d")
      .needs(junit);
  command.add_option("--markdown", options->markdown, "write a summary for the page of a job").option_text("OUT.md");
  command
      .add_option("--coverage", options->coverage,
                  "write all modes, transitions, faults and locations, and how many runs reached each")
      .option_text("OUT.json");
  command.footer(test_notes);
  program.add({command, [options, &common = program.common()] { return run(*options, common); }, AtSignal::tell});
}

}  // namespace rmpl::tools
