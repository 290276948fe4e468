// The answers to a file of properties.
// SPDX-License-Identifier: MIT
#include "verifier/property/table.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "verifier/witness/junit.hpp"
#include "verifier/witness/report.hpp"

namespace rmpl::verifier {

using automata::Plant;
using nlohmann::ordered_json;

namespace {

const char* color_of(const Answer& answer) {
  if (!answer.decided()) return "\033[33m";
  return answer.as_expected() ? "\033[32m" : "\033[31m";
}

/// What has to be said of a verdict beside its word.
std::string remark(const Answer& answer) {
  if (!answer.decided()) return reason(answer.result);
  if (answer.as_expected()) return answer.expect_violated ? "as expected" : "";
  return answer.expect_violated ? "expected to be violated" : "";
}

std::string indented(const std::string& text, const char* margin) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) result += margin + line + "\n";
  return result;
}

/// A trace for people, without the headline of a single result.
std::string trace_of(const Plant& plant, const Answer& answer) {
  if (!answer.result.trace) return "";
  const std::string text =
      to_text(plant, answer.question.property, answer.question.options, answer.result, false, false);
  return text.substr(text.find('\n') + 1);
}

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", seconds);
  return text;
}

}  // namespace

Count count(const std::vector<Answer>& answers) {
  Count result;
  for (const Answer& answer : answers) {
    ++(!answer.decided() ? result.undecided : answer.as_expected() ? result.expected : result.unexpected);
  }
  return result;
}

std::string to_table(const Plant& plant, const std::vector<Answer>& answers, bool statistics, bool color) {
  std::size_t width = 0;
  for (const Answer& answer : answers) width = std::max(width, answer.name.size());
  std::string text;
  for (const Answer& answer : answers) {
    const std::string verdict(to_text(answer.result.verdict));
    const std::string painted = color ? color_of(answer) + verdict + "\033[0m" : verdict;
    std::string line = answer.name + std::string(width - answer.name.size() + 2, ' ') + painted;
    std::string after = remark(answer);
    if (statistics) {
      after += (after.empty() ? "" : ", ") + std::to_string(answer.result.progress.states) + " states, " +
               seconds_text(answer.result.progress.seconds) + " s";
    }
    if (!after.empty()) line += std::string(std::string_view("undecided").size() - verdict.size() + 2, ' ') + after;
    text += line + "\n";
    if (answer.decided() && !answer.as_expected()) text += indented(trace_of(plant, answer), "  ");
  }
  const Count found = count(answers);
  text += std::to_string(found.expected) + " as expected, " + std::to_string(found.unexpected) + " not, " +
          std::to_string(found.undecided) + " undecided\n";
  return text;
}

ordered_json to_json(const Plant& plant, const std::vector<Answer>& answers) {
  ordered_json properties = ordered_json::array();
  for (const Answer& answer : answers) {
    ordered_json one = {{"name", answer.name}, {"expected", answer.expect_violated ? "violated" : "holds"}};
    one.update(to_json(plant, answer.question.property, answer.question.options, answer.result));
    properties.push_back(std::move(one));
  }
  const Count found = count(answers);
  return {{"plant", plant.name},
          {"properties", std::move(properties)},
          {"as_expected", found.expected},
          {"unexpected", found.unexpected},
          {"undecided", found.undecided}};
}

std::string to_junit(const Plant& plant, const std::vector<Answer>& answers) {
  std::vector<TestCase> cases;
  for (const Answer& answer : answers) {
    using Outcome = TestCase::Outcome;
    const std::string after = remark(answer);
    cases.push_back({.name = answer.name,
                     .classname = plant.name + "." + name_of(answer.question.property),
                     .seconds = answer.result.progress.seconds,
                     .outcome = answer.as_expected() ? Outcome::success
                                : answer.decided()   ? Outcome::failure
                                                     : Outcome::error,
                     .message = std::string(to_text(answer.result.verdict)) + (after.empty() ? "" : ": " + after),
                     .text = trace_of(plant, answer)});
  }
  return to_junit(plant.name, cases);
}

}  // namespace rmpl::verifier
