// Text, JSON and JUnit XML.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/project/report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

#include "automata/place.hpp"
#include "base/printable.hpp"
#include "grammar/source/render.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "tools/rmplc/project/coverage_table.hpp"
#include "tools/rmplc/project/requirements.hpp"

namespace rmpl::tools {
namespace {

using base::TestCase;
using Kind = ProjectTest::Kind;
using Outcome = ProjectTest::Outcome;

/// In the order in which they are counted.
constexpr std::array told = {Outcome::passed, Outcome::failed, Outcome::undecided,
                             Outcome::wrong,  Outcome::broken, Outcome::skipped};

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f s", seconds);
  return text;
}

std::string outcome_word(Outcome outcome, base::Painter painter) {
  std::string word = to_string(outcome);
  if (outcome == Outcome::failed) word = "FAILED";
  word.resize(9, ' ');
  if (outcome == Outcome::passed) return painter.good(word);
  return outcome == Outcome::skipped || outcome == Outcome::undecided ? painter.doubtful(word) : painter.bad(word);
}

/// Below its test; without the blank line that ends a finding.
std::string indented(std::string text) {
  while (text.ends_with("\n\n")) text.pop_back();
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    result += (end > at ? "           " : "") + text.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return result;
}

/// What there is to say of a case that is no success.
std::string reason_of(const TestCase& one) {
  // A finding is rendered whole, and so is what has no answer.
  if (one.classname == "lint" || one.text.starts_with(one.message)) return one.text;
  const std::string place = one.line > 0 ? one.file + ":" + std::to_string(one.line) : std::string();
  const std::string headline = one.name + ": " + one.message + "\n";
  if (place.empty() || !one.text.starts_with(place + ":")) return headline + one.text;
  return place + ": " + headline + one.text.substr(one.text.find('\n') + 1);
}

std::string rate(const CoverageCount& count) {
  return std::to_string(count.touched) + " of " + std::to_string(count.all);
}

std::string coverage_text(const ProjectOutcomes& outcomes, TestDetail detail) {
  constexpr std::size_t most = 10;
  std::string counts, missing;
  for (const CoverageCount& count : count_coverage(outcomes.coverage)) {
    if (count.all == 0) continue;
    counts += (counts.empty() ? "" : ", ") + count.plural() + " " + rate(count);
    std::size_t shown = 0;
    for (const runtime::CoverageItem& item : outcomes.coverage) {
      if (item.kind != count.kind || item.runs > 0) continue;
      if (detail != TestDetail::everything && ++shown > most) continue;
      std::string kind = runtime::to_string(item.kind);
      kind.resize(11, ' ');
      missing += "  " + kind + item.name + automata::in_parentheses(item.origin) + "\n";
    }
    if (shown > most) missing += "  and " + std::to_string(shown - most) + " more: -v shows them\n";
  }
  if (counts.empty()) return {};
  return "touched: " + counts + "\n" + (missing.empty() ? "" : "not touched:\n" + missing);
}

/// `FDIR-12  passed     expectation  burn.scn:12: finished within 30 s (fire and stop)`, a line for all that verifies
/// it.
std::string requirements_text(const ProjectOutcomes& outcomes, TestDetail detail, base::Painter painter) {
  if (outcomes.requirements.empty()) return {};
  std::size_t width = 0;
  for (const Requirement& one : outcomes.requirements) width = std::max(width, one.name.size());
  std::string text;
  for (const Requirement& requirement : outcomes.requirements) {
    if (detail == TestDetail::failures && requirement.outcome() == Outcome::passed) continue;
    std::string name = requirement.name;
    if (requirement.by.empty()) {
      name.resize(width, ' ');
      text += "  " + base::printable(name) + "  " + outcome_word(Outcome::failed, painter) +
              "  no scenario and no property names it\n";
    }
    for (const Verification& one : requirement.by) {
      name.resize(width, ' ');
      std::string kind = kind_of(one);
      kind.resize(11, ' ');
      text += "  " + base::printable(name) + "  " + outcome_word(one.outcome, painter) + "  " + kind + "  " +
              base::printable(title_of(one)) + "\n";
      name.clear();
    }
  }
  if (!text.empty()) text = "requirements:\n" + text;
  std::string missing;
  for (const std::string& name : unverified(outcomes.requirements)) {
    missing += (missing.empty() ? "" : ", ") + base::printable(name);
  }
  return text + (missing.empty() ? "" : painter.bad("no passing test verifies") + " " + missing + "\n");
}

}  // namespace

std::string to_text(const ProjectOutcomes& outcomes, TestDetail detail, base::Painter painter) {
  std::string text;
  for (const ProjectTest& test : outcomes.tests) {
    if (detail == TestDetail::failures && test.outcome == Outcome::passed) continue;
    std::string kind = to_string(test.kind);
    kind.resize(9, ' ');
    text += outcome_word(test.outcome, painter) + "  " + kind + (test.kind == Kind::lint ? test.set : title_of(test)) +
            (detail == TestDetail::everything ? "  " + seconds_text(test.seconds) : "") + "\n";
    for (const TestCase& one : test.cases) {
      if (!is_good(one)) text += indented(reason_of(one));
    }
  }
  std::string counts;
  for (const Outcome outcome : told) {
    const std::size_t count = outcomes.count(outcome);
    if (count == 0 && outcome != Outcome::passed && outcome != Outcome::failed) continue;
    counts += (counts.empty() ? "" : ", ") + std::to_string(count) + " " + to_string(outcome);
  }
  text += (text.empty() ? "" : "\n") + counts + " in " + seconds_text(outcomes.seconds) + "\n";
  if (detail != TestDetail::failures) text += coverage_text(outcomes, detail);
  text += requirements_text(outcomes, detail, painter);
  return text;
}

std::string to_json(const ProjectOutcomes& outcomes) {
  runtime::JsonLine json;
  json.open('{').key("project").string(outcomes.project).key("counts").open('{');
  for (const Outcome outcome : told) json.key(to_string(outcome)).number(outcomes.count(outcome));
  json.close('}').key("tests").open('[');
  const auto place = [&](const std::string& file, std::uint32_t line) {
    if (!file.empty()) json.key("file").string(file);
    if (line > 0) json.key("line").number(line);
  };
  for (const ProjectTest& test : outcomes.tests) {
    json.open('{').key("kind").string(to_string(test.kind)).key("set").string(test.set);
    if (!test.name.empty()) json.key("name").string(test.name);
    place(test.file, 0);
    json.key("outcome").string(to_string(test.outcome)).key("seconds").number(test.seconds);
    json.key("failures").open('[');
    for (const TestCase& one : test.cases) {
      if (is_good(one)) continue;
      json.open('{').key("name").string(one.name);
      place(one.file, one.line);
      json.key("message").string(one.message).key("text").string(one.text).close('}');
    }
    json.close(']').close('}');
  }
  json.close(']').key("coverage").open('{');
  for (const CoverageCount& count : count_coverage(outcomes.coverage)) {
    json.key(count.plural()).open('{').key("touched").number(count.touched).key("all").number(count.all);
    json.key("untouched").open('[');
    for (const runtime::CoverageItem& item : outcomes.coverage) {
      if (item.kind != count.kind || item.runs > 0) continue;
      json.open('{').key("of").string(item.of).key("name").string(item.name);
      place(item.origin.file, item.origin.line);
      json.close('}');
    }
    json.close(']').close('}');
  }
  json.close('}').key("requirements").open('[');
  for (const Requirement& requirement : outcomes.requirements) {
    json.open('{').key("requirement").string(requirement.name);
    json.key("outcome").string(to_string(requirement.outcome()));
    json.key("verified").boolean(requirement.verified()).key("by").open('[');
    for (const Verification& one : requirement.by) {
      json.open('{').key("kind").string(kind_of(one)).key("set").string(one.set).key("name").string(one.test);
      if (!one.expectation.empty()) json.key("expectation").string(one.expectation);
      place(one.file, one.line);
      json.key("outcome").string(to_string(one.outcome)).close('}');
    }
    json.close(']').close('}');
  }
  json.close(']').key("seconds").number(outcomes.seconds).close('}');
  return json.text() + "\n";
}

std::string to_junit(const ProjectOutcomes& outcomes) {
  std::vector<base::TestSuite> suites;
  const ProjectTest* before = nullptr;
  for (const ProjectTest& test : outcomes.tests) {
    const bool same =
        before != nullptr && before->kind == test.kind && before->set == test.set && before->file == test.file;
    if (!same) suites.push_back({test.kind == Kind::lint ? title_of(test) : test.set + ": " + test.file, {}});
    before = &test;
    std::vector<TestCase>& cases = suites.back().cases;
    cases.insert(cases.end(), test.cases.begin(), test.cases.end());
    if (!test.cases.empty()) continue;
    const bool skipped = test.outcome == Outcome::skipped;
    cases.push_back({.name = test.kind == Kind::lint ? "no finding" : title_of(test),
                     .classname = test.kind == Kind::lint ? "lint" : test.file,
                     .seconds = test.seconds,
                     .outcome = skipped ? TestCase::Outcome::skipped : TestCase::Outcome::success,
                     .message = skipped ? "not started: interrupted" : "",
                     .text = {},
                     .file = test.file});
  }
  return base::to_junit(suites);
}

std::string to_github(const ProjectOutcomes& outcomes) {
  std::string text;
  std::set<std::string> seen;  // of a file that several sets have in common, lint tells the same
  for (const SetFindings& set : outcomes.lint) {
    for (const grammar::Diagnostic& finding : set.found) {
      const std::string line = grammar::render_github(std::span(&finding, 1), set.sources);
      if (seen.insert(line).second) text += line;
    }
  }
  for (const ProjectTest& test : outcomes.tests) {
    if (test.kind == Kind::lint) continue;
    for (const TestCase& one : test.cases) {
      if (is_good(one)) continue;
      text += grammar::github_command(grammar::Severity::error, one.file.empty() ? test.file : one.file, one.line,
                                      title_of(test), reason_of(one));
    }
  }
  return text;
}

}  // namespace rmpl::tools
