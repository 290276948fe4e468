// Lints and calls as tasks that threads share.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/project/run.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/temporary_folder.hpp"
#include "base/work_together.hpp"
#include "compiler/lint/lint.hpp"
#include "grammar/source/render.hpp"
#include "tools/rmplc/project/baseline.hpp"
#include "tools/rmplc/project/requirements.hpp"
#include "tools/shared/child_process.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

namespace fs = std::filesystem;
using base::TestCase;
using Clock = std::chrono::steady_clock;
using Outcome = ProjectTest::Outcome;
using Kind = ProjectTest::Kind;

double seconds_from(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A program of this toolchain: the one beside this one, else the one that PATH knows.
std::string program_of(const std::string& name) {
  std::error_code error;
  const fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / name;
  return !error && fs::is_regular_file(beside, error) ? beside.string() : name;
}

/// A finding, or an error of the compiler, as a case.
TestCase case_of(const grammar::Diagnostic& finding, const grammar::Sources& sources) {
  const grammar::SourceFile& file = sources[finding.span.file];
  return {
      .name = grammar::to_string(finding.code) + ": " + finding.message,
      .classname = "lint",
      .seconds = 0,
      .outcome = finding.severity == grammar::Severity::error ? TestCase::Outcome::error : TestCase::Outcome::failure,
      .message = finding.message,
      .text = grammar::render_text(std::span(&finding, 1), sources, false),
      .file = file.name(),
      .line = file.place(finding.span.begin).line};
}

/// What there is to say of a set: of one that does not compile, its errors.
SetFindings findings_of(const PlannedSet& set, const Settings& settings, Baseline known, bool& wrong) {
  const compiler::Compilation& compilation = set.compilation;
  SetFindings result{compilation.findings().sources, {}};
  wrong = !compilation.ok();
  if (wrong) {
    result.found = compilation.findings().diagnostics.sorted();
    return result;
  }
  const grammar::Severity level = settings.level.value_or(grammar::Severity::warning);
  const std::vector<grammar::Diagnostic> findings = compiler::lint(compilation, settings.lint).sorted();
  std::copy_if(findings.begin(), findings.end(), std::back_inserter(result.found),
               [&](const grammar::Diagnostic& finding) { return finding.severity >= level; });
  result.found = known.unknown(result.found, result.sources);
  return result;
}

Outcome outcome_of_exit(const std::optional<int>& status) {
  if (!status) return Outcome::broken;
  switch (static_cast<ExitStatus>(*status)) {
    case ExitStatus::done:
      return Outcome::passed;
    case ExitStatus::violated:
      return Outcome::failed;
    case ExitStatus::wrong_input:
      return Outcome::wrong;
    case ExitStatus::undecided:
      return Outcome::undecided;
    case ExitStatus::internal_error:
      break;
  }
  return Outcome::broken;
}

class Run {
 public:
  Run(const TestPlan& plan, const TestChoice& choice, const Settings& settings)
      : plan_(plan),
        choice_(choice),
        settings_(settings),
        lints_(plan.lints ? plan.sets.size() : 0),
        found_(lints_),
        tests_(lints_ + plan.calls.size()),
        coverage_(plan.calls.size()) {
    const std::string known = settings.manifest ? baseline_of(*settings.manifest) : std::string();
    if (!known.empty()) baseline_ = Baseline(known);
  }

  ProjectOutcomes run(unsigned jobs) {
    const auto start = Clock::now();
    base::share_tasks(jobs, tests_.size(), [this](std::size_t task, std::size_t) {
      if (task < lints_) {
        lint(task);
      } else {
        call(task);
      }
    });
    return collected(start);
  }

 private:
  void lint(std::size_t task) {
    ProjectTest test;
    test.set = plan_.sets[task].name;
    if (interrupted()) {
      test.outcome = Outcome::skipped;
    } else {
      const auto start = Clock::now();
      bool wrong = false;
      SetFindings& found = found_[task] = findings_of(plan_.sets[task], settings_, baseline_, wrong);
      for (const grammar::Diagnostic& finding : found.found) test.cases.push_back(case_of(finding, found.sources));
      test.outcome = wrong ? Outcome::wrong : test.cases.empty() ? Outcome::passed : Outcome::failed;
      test.seconds = seconds_from(start);
    }
    tests_[task].push_back(std::move(test));
  }

  /// The tests that a call stands for, before it is made.
  [[nodiscard]] ProjectTest test_of(const PlannedCall& call) const {
    ProjectTest test;
    test.kind = call.kind == PlannedCall::Kind::scenario ? Kind::scenario : Kind::property;
    test.set = plan_.sets[call.set].name;
    test.file = call.file;
    if (call.kind == PlannedCall::Kind::scenario && !call.names.empty()) test.name = call.names.front();
    return test;
  }

  void call(std::size_t task) {
    const PlannedCall& call = plan_.calls[task - lints_];
    std::vector<ProjectTest>& tests = tests_[task];
    ProjectTest whole = test_of(call);
    if (interrupted()) {
      whole.outcome = Outcome::skipped;
      tests.push_back(std::move(whole));
      return;
    }
    const auto start = Clock::now();
    const ChildEnd end = run_program(call, task);
    whole.seconds = seconds_from(start);
    whole.outcome = outcome_of_exit(end.status);
    if (!take_answer(call, end, whole, tests)) {
      const std::string reason = end.late     ? "not done within the time limit\n" + end.errors
                                 : end.status ? end.errors
                                              : "ended by signal " + std::to_string(end.signal) + "\n" + end.errors;
      whole.cases = {base::no_answer(title_of(whole), whole.set, reason.empty() ? "no answer\n" : reason)};
      whole.cases.front().file = call.file;
      tests = {std::move(whole)};
    }
    read_coverage(task);
  }

  ChildEnd run_program(const PlannedCall& call, std::size_t task) {
    ChildCall child{.arguments = call.arguments, .interrupted = interrupted};
    child.arguments.front() = program_of(call.arguments.front());
    child.arguments.insert(child.arguments.end(), {"--coverage", file_of(task)});
    if (choice_.patience) {
      child.time_limit = std::chrono::duration<double>(static_cast<double>(choice_.patience->count) /
                                                       static_cast<double>(automata::Ticks::per_second));
    }
    std::optional<ChildEnd> end = run_child(child);
    if (!end) throw base::InputError(call.arguments.front() + ", which rmplc test runs, is not installed");
    return std::move(*end);
  }

  /// Makes tests of what a program has answered; false where it is no answer.
  static bool take_answer(const PlannedCall& call, const ChildEnd& end, const ProjectTest& whole,
                          std::vector<ProjectTest>& tests) {
    std::vector<base::TestSuite> suites;
    try {
      suites = base::read_junit(end.output);
    } catch (const base::InputError&) {
      return false;
    }
    for (base::TestSuite& suite : suites) {
      for (TestCase& one : suite.cases) add(call, whole, std::move(one), end, tests);
    }
    return !tests.empty();
  }

  static void add(const PlannedCall& call, const ProjectTest& whole, TestCase one, const ChildEnd& end,
                  std::vector<ProjectTest>& tests) {
    const bool flight = call.kind == PlannedCall::Kind::scenario;
    // A scenario is its expectations; a file that is wrong is one case.
    const std::string name = flight ? one.classname : one.name;
    const bool wrong = whole.outcome == Outcome::wrong || whole.outcome == Outcome::broken;
    if (wrong && one.file.empty()) one.file = call.file;
    if (tests.empty() || !flight || tests.back().name != name) {
      ProjectTest& test = tests.emplace_back(whole);
      test.name = wrong && call.names.empty() ? std::string() : name;
      if (wrong && !call.names.empty() && flight) test.name = call.names.front();
      test.outcome = Outcome::passed;
      test.seconds = one.seconds;
    }
    ProjectTest& test = tests.back();
    const Outcome outcome = outcome_of(one);
    // What has no answer has none for the reason that the program tells by its end.
    const bool answerless = outcome == Outcome::undecided && wrong;
    test.outcome = std::max(test.outcome, answerless ? whole.outcome : outcome);
    if (outcome == Outcome::undecided && end.late) one.message += ": not done within the time limit";
    test.cases.push_back(std::move(one));
  }

  void read_coverage(std::size_t task) {
    if (!fs::exists(file_of(task))) return;
    coverage_[task - lints_] = runtime::read_coverage(base::read_file(file_of(task)));
  }

  /// A finding in what several sets have in common is one of the first of them.
  static void tell_once(std::vector<ProjectTest>& tests) {
    std::set<std::string> told;
    for (ProjectTest& test : tests) {
      if (test.kind != Kind::lint || test.outcome != Outcome::failed) continue;
      std::erase_if(test.cases, [&](const TestCase& one) { return !told.insert(one.text).second; });
      if (test.cases.empty()) test.outcome = Outcome::passed;
    }
  }

  ProjectOutcomes collected(Clock::time_point start) {
    ProjectOutcomes result;
    std::vector<std::pair<std::string, Verification>> verifications;
    for (std::size_t c = 0; c < plan_.calls.size(); ++c) {
      for (const RequirementTag& tag : plan_.calls[c].tags) {
        verifications.emplace_back(tag.requirement, verification_of(tag, tests_[lints_ + c]));
      }
    }
    for (std::vector<ProjectTest>& some : tests_) {
      std::move(some.begin(), some.end(), std::back_inserter(result.tests));
    }
    // Lint of a set stands before its flights.
    const auto position = [&](const ProjectTest& test) {
      return std::find_if(plan_.sets.begin(), plan_.sets.end(),
                          [&](const PlannedSet& set) { return set.name == test.set; }) -
             plan_.sets.begin();
    };
    std::stable_sort(result.tests.begin(), result.tests.end(),
                     [&](const ProjectTest& a, const ProjectTest& b) { return position(a) < position(b); });
    tell_once(result.tests);
    result.lint = std::move(found_);
    for (const auto& items : coverage_) runtime::add(result.coverage, items);
    result.requirements = matrix_of(plan_.requirements, verifications);
    result.seconds = seconds_from(start);
    return result;
  }

  /// Where the program of a call writes what it covers.
  [[nodiscard]] std::string file_of(std::size_t task) const { return (folder_.path() / std::to_string(task)).string(); }

  const TestPlan& plan_;
  const TestChoice& choice_;
  const Settings& settings_;
  base::TemporaryFolder folder_ = base::TemporaryFolder::of_system("rmplc-test-");  ///< for what programs write
  Baseline baseline_;                                                               ///< each set begins with all of it
  std::size_t lints_;                                                               ///< tasks from the front
  std::vector<SetFindings> found_;
  std::vector<std::vector<ProjectTest>> tests_;  ///< by task
  std::vector<std::vector<runtime::CoverageItem>> coverage_;
};

}  // namespace

ProjectOutcomes run_tests(const TestPlan& plan, const TestChoice& choice, const Settings& settings, unsigned jobs) {
  return Run(plan, choice, settings).run(jobs);
}

}  // namespace rmpl::tools
