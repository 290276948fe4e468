// Results about programs as JUnit XML.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/program_junit.hpp"

#include "verifier/witness/junit.hpp"

namespace rmpl::verifier {
namespace {

using enum TestCase::Outcome;

/// A report of one property: its headline, which ends the first line, and what follows it.
std::pair<std::string, std::string> parted(const std::string& report) {
  const auto end = report.find('\n');
  return {report.substr(0, end), report.substr(end + 1)};
}

}  // namespace

std::string to_junit(const ProgramSubject& subject, const std::vector<ProgramProperty>& properties,
                     const ProgramResult& result) {
  std::vector<TestCase> cases;
  for (std::size_t p = 0; p < properties.size(); ++p) {
    const ProgramProperty& property = properties[p];
    const Verdict verdict = result.answers[p].verdict;
    ProgramResult one{.answers = {result.answers[p]}, .limit = result.limit, .progress = result.progress};
    auto [message, text] = parted(to_text(subject, {property}, one, false, false));
    const std::string kind(name_of(property.kind));
    cases.push_back({.name = property.text.empty() ? kind : kind + " " + property.text,
                     .classname = subject.plant.name + "." + subject.program.name,
                     .seconds = p == 0 ? result.progress.seconds : 0.0,
                     .outcome = verdict == Verdict::holds      ? success
                                : verdict == Verdict::violated ? failure
                                                               : error,
                     .message = std::move(message),
                     .text = std::move(text)});
  }
  return to_junit(title(subject), cases);
}

std::string to_junit(const ProgramSubject& subject, const FaultTable& table) {
  std::vector<TestCase> cases;
  for (const FaultOutcome& row : table.rows) {
    std::string message;
    for (const std::string& outcome : outcomes_of(row)) message += (message.empty() ? "" : ", ") + outcome;
    cases.push_back({.name = name_of(subject, row),
                     .classname = subject.plant.name + "." + subject.program.name,
                     .seconds = cases.empty() ? table.progress.seconds : 0.0,
                     .outcome = row.fails()    ? failure
                                : !row.decided ? error
                                               : success,
                     .message = std::move(message),
                     .text = failure_text(subject, row)});
  }
  return to_junit(title(subject), cases);
}

}  // namespace rmpl::verifier
