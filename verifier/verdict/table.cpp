// The answers to a file of properties.
// SPDX-License-Identifier: MIT
#include "verifier/verdict/table.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "automata/place.hpp"
#include "base/junit.hpp"
#include "base/painter.hpp"
#include "verifier/verdict/report.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::verifier {

using nlohmann::ordered_json;

namespace {

std::string paint(const Claim& claim, const std::string& verdict, const base::Painter& painter) {
  if (!claim.decided()) return painter.doubtful(verdict);
  return claim.as_expected() ? painter.good(verdict) : painter.bad(verdict);
}

/// What was found of a probability, beside what is claimed.
std::string found(const Claim& claim) {
  return "the probability is " + claim.measure->text + ", claimed: at " +
         (claim.measure->at_least ? "least " : "most ") + number_text(claim.measure->bound);
}

/// What has to be said of a verdict beside its word.
std::string remark(const Claim& claim) {
  if (!claim.decided()) return claim.measure && !claim.answer.limit ? found(claim) : reason(claim.answer);
  std::string text(claim.severity ? name_of(*claim.severity) : "");
  if (claim.hazard) text += text.empty() ? "hazard" : " hazard";
  if (claim.measure) text += (text.empty() ? "" : "; ") + found(claim);
  const std::string expected = !claim.expect_violated ? ""
                               : claim.as_expected()  ? "as expected"
                                                      : "expected to be violated";
  if (!expected.empty()) text += (text.empty() ? "" : "; ") + expected;
  if (holds_vacuously(claim.answer)) {
    text += (text.empty() ? "" : "; ") + ("vacuous: " + vacuity(claim.answer));
  }
  if (const std::string part = partly(claim.answer); !part.empty()) text += (text.empty() ? "" : "; ") + part;
  return text;
}

std::string indented(const std::string& text, const char* margin) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) result += margin + line + "\n";
  return result;
}

/// What the claim is about: the plant alone, or under the program.
Subject subject_of(const Subject& all, const Claim& claim) { return claim.of_program() ? all : Subject{all.plant}; }

/// A trace for people, without the headline of a single result.
std::string trace_of(const Subject& subject, const Claim& claim) {
  if (claim.measure) return claim.answer.limit ? "" : found(claim) + "\n";
  const std::string text = to_text(subject_of(subject, claim), claim.question, claim.answer, false);
  return text.substr(text.find('\n') + 1);
}

/// `  (power.props:3)`, to stand at the end of a line.
std::string place_of(const Claim& claim) {
  return claim.origin.line == 0 ? "" : " " + automata::in_parentheses(claim.origin);
}

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", seconds);
  return text;
}

}  // namespace

Count count(const std::vector<Claim>& claims) {
  Count result;
  for (const Claim& claim : claims) {
    ++(!claim.decided() ? result.undecided : claim.as_expected() ? result.expected : result.unexpected);
  }
  return result;
}

std::string to_table(const Subject& subject, const std::vector<Claim>& claims, bool statistics, bool color) {
  std::size_t width = 0;
  for (const Claim& claim : claims) width = std::max(width, claim.name.size());
  const base::Painter painter{color};
  std::string text;
  for (const Claim& claim : claims) {
    const std::string verdict(to_text(claim.answer.verdict));
    const std::string painted = paint(claim, verdict, painter);
    std::string line = claim.name + std::string(width - claim.name.size() + 2, ' ') + painted;
    std::string after = remark(claim);
    if (statistics) {
      after += (after.empty() ? "" : ", ") + std::to_string(claim.answer.progress.states) + " states, " +
               seconds_text(claim.answer.progress.seconds) + " s";
    }
    if (!after.empty()) line += std::string(std::string_view("undecided").size() - verdict.size() + 2, ' ') + after;
    text += line + painter.quiet(place_of(claim)) + "\n";
    if (claim.decided() && !claim.as_expected()) text += indented(trace_of(subject, claim), "  ");
  }
  const Count found = count(claims);
  text += std::to_string(found.expected) + " as expected, " + std::to_string(found.unexpected) + " not, " +
          std::to_string(found.undecided) + " undecided\n";
  return text;
}

ordered_json to_json(const Subject& subject, const std::vector<Claim>& claims) {
  ordered_json properties = ordered_json::array();
  for (const Claim& claim : claims) {
    ordered_json one = {{"name", claim.name}};
    if (claim.origin.line > 0) one.update({{"file", claim.origin.file}, {"line", claim.origin.line}});
    one.update({{"expected", claim.expect_violated ? "violated" : "holds"},
                {"subject", claim.of_program() ? "program" : "plant"}});
    if (claim.hazard) one["hazard"] = true;
    if (claim.severity) one["severity"] = name_of(*claim.severity);
    if (!claim.requirements.empty()) one["requirements"] = claim.requirements;
    one.update(to_json(subject_of(subject, claim), claim.question, claim.answer));
    if (claim.measure) {
      const Measure& measure = *claim.measure;
      one["property"] = "probability";
      one["question"]["within"] =
          measure.within.is_infinite() ? ordered_json("inf") : ordered_json(measure.within.seconds());
      one["question"][measure.at_least ? "at_least" : "at_most"] = measure.bound;
      if (!claim.answer.limit) one.update({{"lower", measure.lower}, {"upper", measure.upper}});
    }
    properties.push_back(std::move(one));
  }
  const Count found = count(claims);
  ordered_json json = {{"plant", subject.plant.name}};
  if (subject.program != nullptr) json["program"] = subject.program->name;
  json["properties"] = std::move(properties);
  json["as_expected"] = found.expected;
  json["unexpected"] = found.unexpected;
  json["undecided"] = found.undecided;
  return json;
}

std::string to_junit(const Subject& subject, const std::vector<Claim>& claims) {
  std::vector<base::TestCase> cases;
  for (const Claim& claim : claims) {
    using Outcome = base::TestCase::Outcome;
    const std::string after = remark(claim);
    const std::string trace = trace_of(subject, claim);
    // What was asked for, also where it is as expected; else the trace tells it.
    const bool cut_sets = claim.question.options.cut_sets && claim.as_expected();
    cases.push_back({.name = claim.name,
                     .classname = subject.plant.name + "." + (claim.of_program() ? subject.program->name + "." : "") +
                                  (claim.origin.file.empty() ? "" : claim.origin.file + ".") +
                                  (claim.measure ? "probability" : name_of(claim.question.property)),
                     .seconds = claim.answer.progress.seconds,
                     .outcome = claim.as_expected() ? Outcome::success
                                : claim.decided()   ? Outcome::failure
                                                    : Outcome::error,
                     .message = std::string(to_text(claim.answer.verdict)) + (after.empty() ? "" : ": " + after),
                     .text = trace,
                     .notes = notes(claim.answer) + (cut_sets ? trace : ""),
                     .file = claim.origin.file,
                     .line = claim.origin.line,
                     .requirements = claim.requirements});
    if (claim.origin.line > 0) {
      cases.back().text =
          automata::short_place(claim.origin) + ": property \"" + claim.name + "\"\n" + cases.back().text;
    }
  }
  const bool of_file = !claims.empty() && !claims.front().origin.file.empty();
  return base::to_junit((of_file ? claims.front().origin.file + ": " : "") + title(subject), cases);
}

}  // namespace rmpl::verifier
