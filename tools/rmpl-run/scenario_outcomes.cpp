// One list, of which every form of the answer is made.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/scenario_outcomes.hpp"

#include <algorithm>

#include "base/junit.hpp"
#include "runtime/executive/scenario/report.hpp"
#include "runtime/executive/trace/json_line.hpp"

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

void append(std::vector<TestCase>& cases, const automata::Scenario& scenario, const Flown* flown) {
  double seconds = flown == nullptr ? 0 : flown->seconds;
  const auto add = [&](const std::string& name, const automata::Origin& origin) -> TestCase& {
    cases.push_back({.name = name,
                     .classname = scenario.name,
                     .seconds = std::exchange(seconds, 0),
                     .outcome = TestCase::Outcome::skipped,
                     .message = "not flown: interrupted",
                     .text = {},
                     .file = origin.file,
                     .line = origin.line,
                     .requirements = scenario.requirements});
    return cases.back();
  };
  for (std::size_t i = 0; i < scenario.expectations.size(); ++i) {
    TestCase& one = add(scenario.expectations[i].text, scenario.expectations[i].origin);
    const auto& own = scenario.expectations[i].requirements;
    one.requirements.insert(one.requirements.end(), own.begin(), own.end());
    if (flown == nullptr) continue;
    const Judgement& judgement = flown->result.judgements[i];
    one.outcome = outcome_of(judgement.verdict);
    one.message = judgement.reason;
    one.text = details(scenario.expectations[i], judgement);
  }
  if (!scenario.expectations.empty()) return;
  TestCase& one = add("flown to its end", scenario.origin);
  if (flown == nullptr) return;
  one.outcome = outcome_of(flown->result.verdict());
  one.message = flown->result.interrupted ? "interrupted" : "";
}

ExitStatus status_of(const ScenarioOutcome& outcome) {
  if (outcome.wrong()) return ExitStatus::wrong_input;
  if (outcome.flown == nullptr) return ExitStatus::undecided;
  switch (outcome.flown->result.verdict()) {
    case Judgement::Verdict::met:
      return ExitStatus::done;
    case Judgement::Verdict::failed:
      return ExitStatus::violated;
    case Judgement::Verdict::undecided:
      return ExitStatus::undecided;
  }
  return ExitStatus::undecided;
}

}  // namespace

std::vector<ScenarioOutcome> outcomes_of(const std::vector<ScenarioFile>& files, const std::vector<Task>& tasks,
                                         const std::vector<std::optional<Flown>>& flights) {
  std::vector<ScenarioOutcome> outcomes;
  std::size_t t = 0;
  for (const ScenarioFile& file : files) {
    if (!file.compilation) outcomes.push_back({&file});
    if (!file.compilation) continue;
    const auto scenarios = file.scenarios();
    const auto is_of_file = [&](const Task& task) {
      return std::any_of(scenarios.begin(), scenarios.end(), [&](const auto& own) { return &own == task.scenario; });
    };
    for (; t < tasks.size() && is_of_file(tasks[t]); ++t) {
      outcomes.push_back({&file, tasks[t].scenario, flights[t] ? &*flights[t] : nullptr});
    }
  }
  return outcomes;
}

ExitStatus status_of(const std::vector<ScenarioOutcome>& outcomes) {
  ExitStatus status = ExitStatus::done;
  for (const ExitStatus heaviest : {ExitStatus::undecided, ExitStatus::violated, ExitStatus::wrong_input}) {
    for (const ScenarioOutcome& outcome : outcomes) {
      if (status_of(outcome) == heaviest) status = heaviest;
    }
  }
  return status;
}

std::string to_json(const std::vector<ScenarioOutcome>& outcomes) {
  runtime::JsonLine json;
  json.open('{').key("scenarios").open('[');
  bool all = true;
  for (const ScenarioOutcome& outcome : outcomes) {
    if (outcome.flown != nullptr) runtime::write_result(json, *outcome.scenario, outcome.flown->result);
    all = all && outcome.flown != nullptr;
  }
  json.close(']');
  if (!all) {
    json.key("not_flown").open('[');
    for (const ScenarioOutcome& outcome : outcomes) {
      if (outcome.flown != nullptr) continue;
      json.open('{').key("file").string(outcome.file->path);
      if (outcome.scenario != nullptr) json.key("scenario").string(outcome.scenario->name);
      json.key("reason").string(outcome.wrong() ? outcome.file->wrong : "interrupted").close('}');
    }
    json.close(']');
  }
  json.close('}');
  return json.text() + "\n";
}

std::string to_junit(const std::vector<ScenarioOutcome>& outcomes) {
  std::vector<base::TestSuite> suites;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const ScenarioOutcome& outcome = outcomes[i];
    const std::string& path = outcome.file->path;
    if (i == 0 || outcomes[i - 1].file != outcome.file) suites.push_back({path, {}});
    std::vector<TestCase>& cases = suites.back().cases;
    if (outcome.scenario != nullptr) {
      append(cases, *outcome.scenario, outcome.flown);
    } else if (outcome.wrong()) {
      cases.push_back(base::no_answer(path, path, outcome.file->wrong));
    } else {
      cases.push_back({path, path, 0, TestCase::Outcome::skipped, "not read: interrupted", {}});
    }
  }
  return base::to_junit(suites);
}

}  // namespace rmpl::tools
