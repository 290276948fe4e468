// The answer as Markdown, for the page of a job.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "automata/place.hpp"
#include "base/printable.hpp"
#include "tools/rmplc/project/coverage_table.hpp"
#include "tools/rmplc/project/report.hpp"
#include "tools/rmplc/project/requirements.hpp"

namespace rmpl::tools {
namespace {

using Outcome = ProjectTest::Outcome;

/// Text that stands in a cell of a table as it is.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : base::printable(text)) {
    if (std::string_view("\\`*_{}[]<>#|&~").find(c) != std::string_view::npos) result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

/// The rows of the sets: how many tests of each kind there are, and how many did not pass.
std::string sets_table(const ProjectOutcomes& outcomes) {
  std::vector<std::string> sets;
  for (const ProjectTest& test : outcomes.tests) {
    if (std::find(sets.begin(), sets.end(), test.set) == sets.end()) sets.push_back(test.set);
  }
  std::string text = "| set | lint | scenarios | properties |\n|---|---|---|---|\n";
  for (const std::string& set : sets) {
    text += "| " + cell(set);
    for (const auto kind : {ProjectTest::Kind::lint, ProjectTest::Kind::scenario, ProjectTest::Kind::property}) {
      std::size_t all = 0, passed = 0;
      for (const ProjectTest& test : outcomes.tests) {
        if (test.set != set || test.kind != kind) continue;
        ++all;
        if (test.outcome == Outcome::passed) ++passed;
      }
      const std::string count = std::to_string(passed) + " of " + std::to_string(all) + " passed";
      text += " | " + (all == 0 ? "" : passed == all ? count : "**" + count + "**");
    }
    text += " |\n";
  }
  return text;
}

std::string failures_table(const ProjectOutcomes& outcomes) {
  std::string rows;
  for (const ProjectTest& test : outcomes.tests) {
    if (test.outcome == Outcome::passed) continue;
    for (const base::TestCase& one : test.cases) {
      if (is_good(one)) continue;
      const std::string place = one.line > 0 ? one.file + ":" + std::to_string(one.line) : one.file;
      rows += "| " + cell(title_of(test)) + " | " + to_string(test.outcome) + " | " + cell(one.name) +
              (one.classname == "lint" ? "" : ": " + cell(one.message)) + " | " + cell(place) + " |\n";
    }
    if (test.cases.empty()) rows += "| " + cell(title_of(test)) + " | " + to_string(test.outcome) + " |  |  |\n";
  }
  return rows.empty() ? "" : "\n| test | outcome | what | where |\n|---|---|---|---|\n" + rows;
}

/// A row for all that verifies a requirement; then which ones nothing does.
std::string requirements_table(const ProjectOutcomes& outcomes) {
  if (outcomes.requirements.empty()) return {};
  std::string text = "\n| requirement | verified by | outcome |\n|---|---|---|\n";
  for (const Requirement& requirement : outcomes.requirements) {
    if (requirement.by.empty()) text += "| " + cell(requirement.name) + " | nothing | **failed** |\n";
    for (const Verification& one : requirement.by) {
      const std::string word = to_string(one.outcome);
      text += "| " + cell(requirement.name) + " | " + kind_of(one) + " " + cell(title_of(one)) + " | " +
              (one.outcome == Outcome::passed ? word : "**" + word + "**") + " |\n";
    }
  }
  std::string missing;
  for (const std::string& name : unverified(outcomes.requirements)) {
    missing += (missing.empty() ? "" : ", ") + cell(name);
  }
  return text + (missing.empty() ? "" : "\n**No passing test verifies** " + missing + "\n");
}

std::string coverage_table(const ProjectOutcomes& outcomes) {
  if (outcomes.coverage.empty()) return {};
  std::string text = "\n| touched | of | in all |\n|---|---|---|\n";
  for (const CoverageCount& count : count_coverage(outcomes.coverage)) {
    text += "| " + count.plural() + " | " + std::to_string(count.touched) + " | " + std::to_string(count.all) + " |\n";
  }
  std::string missing;
  for (const runtime::CoverageItem& item : outcomes.coverage) {
    if (item.runs > 0) continue;
    missing += std::string("- ") + runtime::to_string(item.kind) + " " + cell(item.name) +
               cell(automata::in_parentheses(item.origin)) + "\n";
  }
  if (missing.empty()) return text;
  return text + "\n<details><summary>not touched</summary>\n\n" + missing + "\n</details>\n";
}

}  // namespace

std::string to_markdown(const ProjectOutcomes& outcomes) {
  const std::size_t passed = outcomes.count(Outcome::passed);
  return "## " + cell(outcomes.project) + ": " + std::to_string(passed) + " of " +
         std::to_string(outcomes.tests.size()) + " tests passed\n\n" + sets_table(outcomes) + failures_table(outcomes) +
         requirements_table(outcomes) + coverage_table(outcomes);
}

}  // namespace rmpl::tools
