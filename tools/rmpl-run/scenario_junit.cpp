// Expectations, one case each.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/scenario_junit.hpp"

#include "base/junit.hpp"

namespace rmpl::tools {
namespace {

using base::TestCase;
using runtime::Judgement;

TestCase::Outcome outcome_of(Judgement::Verdict verdict) {
  switch (verdict) {
    case Judgement::Verdict::met:
      return TestCase::Outcome::success;
    case Judgement::Verdict::failed:
      return TestCase::Outcome::failure;
    case Judgement::Verdict::undecided:
      return TestCase::Outcome::error;
  }
  return TestCase::Outcome::error;
}

/// Where the expectation stands, and what was the case when it failed.
std::string details(const automata::Expectation& expectation, const Judgement& judgement) {
  std::string text;
  if (expectation.origin.line > 0) {
    text =
        expectation.origin.file + ":" + std::to_string(expectation.origin.line) + ": expect " + expectation.text + "\n";
  }
  if (judgement.time) text += "at " + automata::format_seconds(*judgement.time) + " s\n";
  if (!judgement.evidence.empty()) text += judgement.evidence + "\n";
  return text;
}

void append(std::vector<TestCase>& cases, const Flown& flown) {
  const automata::Scenario& scenario = *flown.scenario;
  double seconds = flown.seconds;
  for (std::size_t i = 0; i < scenario.expectations.size(); ++i) {
    const Judgement& judgement = flown.result.judgements[i];
    cases.push_back({scenario.expectations[i].text, scenario.name, seconds, outcome_of(judgement.verdict),
                     judgement.reason, details(scenario.expectations[i], judgement)});
    seconds = 0;
  }
  if (!scenario.expectations.empty()) return;
  cases.push_back({"flown to its end",
                   scenario.name,
                   seconds,
                   outcome_of(flown.result.verdict()),
                   flown.result.interrupted ? "interrupted" : "",
                   {}});
}

}  // namespace

std::string to_junit(const std::vector<Task>& tasks, const std::vector<Flown>& flights) {
  std::vector<base::TestSuite> suites;
  for (std::size_t f = 0; f < flights.size(); ++f) {
    if (f == 0 || tasks[f].file != tasks[f - 1].file) suites.push_back({tasks[f].file, {}});
    append(suites.back().cases, flights[f]);
  }
  return base::to_junit(suites);
}

}  // namespace rmpl::tools
