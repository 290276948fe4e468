// Answers as text, as JSON and as JUnit XML.
// SPDX-License-Identifier: MIT
#include "verifier/verdict/report.hpp"

#include <algorithm>

#include "automata/assignment_text.hpp"
#include "base/junit.hpp"
#include "verifier/verdict/cause.hpp"
#include "verifier/verdict/question_json.hpp"
#include "verifier/verdict/trace.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::verifier {

using automata::Plant;
using nlohmann::ordered_json;

std::string end_of(const Subject& subject, const Property& property, const Witness& witness) {
  const auto* asked = std::get_if<ProgramProperty>(&property);
  if (asked != nullptr) return finding(subject, *asked, witness);
  const auto* response = std::get_if<Response>(&property);
  if (response != nullptr && witness.owed_since) return owed_text(subject, *response, witness);
  return witness.stop ? to_text(subject.plant, *witness.stop) : "";
}

namespace {

std::string faults_text(unsigned faults) { return std::to_string(faults) + (faults == 1 ? " fault" : " faults"); }

std::string text_of_cut_sets(const Subject& subject, const Question& question, const Answer& answer) {
  if (answer.verdict == Verdict::undecided && !answer.limit) return "";
  const Plant& plant = subject.plant;
  std::string text = "minimal cut sets of up to " + faults_text(question.options.faults.value()) + ": ";
  if (answer.verdict != Verdict::undecided) {
    text += std::to_string(answer.cut_sets.size());
  } else {
    const std::size_t found = answer.cut_sets.size();
    text += found == 0 ? "none so far" : found == 1 ? "at least this one" : "at least these " + std::to_string(found);
    if (answer.cut_sets_complete) text += "; complete up to " + faults_text(*answer.cut_sets_complete);
  }
  text += "\n";
  for (const CutSet& cut : answer.cut_sets) {
    text += "\ncut set:";
    for (std::size_t f = 0; f < cut.faults.size(); ++f) {
      text += (f == 0 ? " " : ", ") + to_text(plant[cut.faults[f].component], cut.faults[f].mode);
    }
    const bool program = std::holds_alternative<ProgramProperty>(question.property);
    text += (cut.faults.empty() ? " no fault is needed\n" : "\n") +
            text_of(subject, cut.witness, program ? end_of(subject, question.property, cut.witness) : "");
  }
  return text;
}

void add_cut_sets(ordered_json& json, const Subject& subject, const Answer& answer) {
  auto sets = ordered_json::array();
  for (const CutSet& cut : answer.cut_sets) {
    auto faults = ordered_json::array();
    for (const Fault& f : cut.faults) {
      faults.push_back({{"component", subject.plant[f.component].name},
                        {"mode", subject.plant[f.component].modes[f.mode.index()].name}});
    }
    sets.push_back({{"faults", std::move(faults)}, {"trace", json_of(subject, cut.witness)}});
  }
  json["cut_sets"] = std::move(sets);
  if (answer.cut_sets_complete) json["cut_sets_complete_up_to"] = *answer.cut_sets_complete;
}

/// Further missing plans and endless waits.
void add_others(ordered_json& json, const Subject& subject, const Property& property, const Answer& answer) {
  for (const Witness& other : answer.others) {
    json["others"].push_back({{"finding", end_of(subject, property, other)}, {"trace", json_of(subject, other)}});
  }
}

/// What a verdict without a witness leaves out.
void add_cut_off(ordered_json& json, const Answer& answer) {
  const CutOff& cut_off = answer.cut_off;
  if (answer.witness || (!cut_off.stuck && !cut_off.still && !cut_off.spent)) return;
  json["cut_off"] = cut_off.still ? "time-stands-still" : cut_off.stuck ? "stuck" : "fault-certain";
}

void add_warnings(ordered_json& json, const Answer& answer) {
  if (!answer.warnings.empty()) json["warnings"] = answer.warnings;
}

ordered_json check_json(const Subject& subject, const Property& property, bool cut_sets, const Answer& answer) {
  ordered_json check = {{"property", name_of(property)}, {"verdict", to_text(answer.verdict)}};
  if (is_warning(property)) check["level"] = "warning";
  check.update(claim_of(subject.plant, property));
  if (holds_vacuously(answer)) check["vacuous"] = true;
  add_cut_off(check, answer);
  add_warnings(check, answer);
  if (cut_sets) add_cut_sets(check, subject, answer);
  if (!answer.witness) return check;
  if (answer.fewest_faults) check["fewest_faults"] = *answer.fewest_faults;
  check["finding"] = end_of(subject, property, *answer.witness);
  if (answer.same_as) {
    check["same_as"] = *answer.same_as;
    return check;
  }
  check["trace"] = json_of(subject, *answer.witness);
  if (answer.witness->repeats_from) check["repeats_from"] = *answer.witness->repeats_from;
  add_others(check, subject, property, answer);
  return check;
}

}  // namespace

std::string to_text(const Subject& subject, const Question& question, const Answer& answer, bool color) {
  const bool warning = is_warning(question.property);
  std::string text = name_of(question.property) + ": " + painted(answer.verdict, color, warning) + " (" +
                     (warning && answer.witness ? "warning: " : "") + meaning(question.property, answer) + ")\n";
  if (question.options.cut_sets) {
    text += text_of_cut_sets(subject, question, answer);
  } else if (answer.witness && answer.same_as) {
    text += "  the same witness as for endless-wait\n";
  } else if (answer.witness) {
    if (answer.fewest_faults) text += "fewest faults: " + std::to_string(*answer.fewest_faults) + "\n";
    text += text_of(subject, *answer.witness, end_of(subject, question.property, *answer.witness));
  }
  for (const Witness& other : answer.others) {
    text += "  also, at " + automata::format_seconds(other.events.back().time) +
            " s: " + end_of(subject, question.property, other) + "\n";
  }
  const bool listed = std::holds_alternative<ProgramProperty>(question.property);
  if (answer.witness && answer.limit) {
    text += std::string(listed ? "there may be more: " : "a better trace may exist: ") + reason(answer) + "\n";
  }
  return text;
}

ordered_json to_json(const Subject& subject, const Question& question, const Answer& answer) {
  ordered_json json = {{"property", name_of(question.property)},
                       {"question", question_json(subject.plant, question)},
                       {"verdict", to_text(answer.verdict)}};
  if (holds_vacuously(answer)) json["vacuous"] = true;
  if (const std::string why = reason(answer); !why.empty()) json["reason"] = why;
  add_cut_off(json, answer);
  add_warnings(json, answer);
  if (answer.witness) {
    if (auto found = end_of(subject, question.property, *answer.witness); !found.empty()) json["finding"] = found;
  }
  if (answer.witness && answer.witness->repeats_from) json["repeats_from"] = *answer.witness->repeats_from;
  json["trace"] = answer.witness ? json_of(subject, *answer.witness) : ordered_json::array();
  add_others(json, subject, question.property, answer);
  if (answer.fewest_faults) json["fewest_faults"] = *answer.fewest_faults;
  if (question.options.cut_sets) add_cut_sets(json, subject, answer);
  json["statistics"] = statistics_of(answer.progress);
  return json;
}

ordered_json to_json(const Subject& subject, const ProgramQuestion& question, const std::vector<Answer>& answers) {
  const std::vector<Property>& properties = question.properties;
  ordered_json json = {{"property", "program"},
                       {"question", question_json(subject.plant, question)},
                       {"verdict", to_text(overall(properties, answers))}};
  const auto limited = std::find_if(answers.begin(), answers.end(), [](const Answer& a) { return a.limit; });
  if (limited != answers.end()) json["reason"] = reason(*limited);
  json["trace"] = ordered_json::array();
  json["checks"] = ordered_json::array();
  for (std::size_t p = 0; p < properties.size(); ++p) {
    ordered_json check = check_json(subject, properties[p], question.options.cut_sets, answers[p]);
    if (json["trace"].empty() && !is_warning(properties[p]) && check.contains("trace")) json["trace"] = check["trace"];
    json["checks"].push_back(std::move(check));
  }
  json["statistics"] = statistics_of(answers.back().progress);
  return json;
}

std::string to_junit(const Subject& subject, const ProgramQuestion& question, const std::vector<Answer>& answers) {
  const std::vector<Property>& properties = question.properties;
  std::vector<base::TestCase> cases;
  for (std::size_t p = 0; p < properties.size(); ++p) {
    const Verdict verdict = answers[p].verdict;
    const std::string report = to_text(subject, {properties[p], question.options}, answers[p], false);
    const auto headline = report.find('\n');
    const auto* asked = std::get_if<ProgramProperty>(&properties[p]);
    const std::string formula = asked != nullptr ? asked->text : "";
    using enum base::TestCase::Outcome;
    cases.push_back({.name = name_of(properties[p]) + (formula.empty() ? "" : " " + formula),
                     .classname = subject.plant.name + "." + subject.program->name,
                     .seconds = p == 0 ? answers.back().progress.seconds : 0.0,
                     .outcome = verdict == Verdict::holds      ? success
                                : is_warning(properties[p])    ? warning
                                : verdict == Verdict::violated ? failure
                                                               : error,
                     .message = report.substr(0, headline),
                     .text = report.substr(headline + 1),
                     .notes = notes(answers[p])});
  }
  return base::to_junit(title(subject), cases);
}

ordered_json statistics_of(const Progress& progress) {
  return {{"states", progress.states}, {"seconds", progress.seconds}, {"peak_bytes", peak_bytes()}};
}

}  // namespace rmpl::verifier
