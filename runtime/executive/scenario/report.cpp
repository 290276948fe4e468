// Verdicts for people and for programs.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/report.hpp"

#include "runtime/executive/scenario/moment.hpp"

namespace rmpl::runtime {

using automata::format_seconds;

std::string verdict_word(Judgement::Verdict verdict, base::Painter painter) {
  switch (verdict) {
    case Judgement::Verdict::met:
      return painter.good("met      ");
    case Judgement::Verdict::failed:
      return painter.bad("FAILED   ");
    case Judgement::Verdict::undecided:
      return painter.strong("undecided");
  }
  return {};
}

std::string summary_line(const automata::Expectation& expectation, const Judgement& judgement, base::Painter painter) {
  std::string text = "  " + verdict_word(judgement.verdict, painter) + "  " + expectation.text;
  const bool awaited = !lasts_to_the_end(expectation);
  const std::string at = judgement.time ? " at " + moment(*judgement.time) : "";
  if (awaited && judgement.verdict == Judgement::Verdict::met) text += painter.quiet(" " + at);
  if (!judgement.reason.empty()) text += ": " + judgement.reason + (awaited ? "" : at);
  if (!judgement.evidence.empty()) text += ": " + judgement.evidence;
  return text + "\n";
}

std::string heading(const automata::Document& document, const automata::Scenario& scenario, std::uint64_t seed,
                    base::Painter painter) {
  return painter.strong(scenario.name) + "\n" + "program " + document.programs[scenario.program].name + ", plant " +
         document.plant_of(scenario).name + (scenario.rules_only ? " (rules only)" : "") + ", a cycle of " +
         format_seconds(scenario.cycle) + " s, seed " + std::to_string(seed) + "\n";
}

std::string summary(const automata::Scenario& scenario, const ScenarioResult& result, base::Painter painter) {
  std::string text;
  if (result.ended) {
    text += "the program ended at " + moment(*result.ended);
  } else if (result.interrupted) {
    text += "interrupted at " + moment(result.time);
  } else {
    text += "the program had not ended after " + moment(result.time);
  }
  text += "; " + std::to_string(result.cycles) + (result.cycles == 1 ? " cycle\n" : " cycles\n");
  for (std::size_t i = 0; i < result.judgements.size(); ++i) {
    text += summary_line(scenario.expectations[i], result.judgements[i], painter);
  }
  return text;
}

namespace {

void write_requirements(JsonLine& json, const std::vector<std::string>& requirements) {
  if (requirements.empty()) return;
  json.key("requirements").open('[');
  for (const std::string& one : requirements) json.string(one);
  json.close(']');
}

}  // namespace

void write_result(JsonLine& json, const automata::Scenario& scenario, const ScenarioResult& result) {
  json.open('{').key("scenario").string(scenario.name).key("verdict").string(name_of(result.verdict()));
  json.key("seed").number(result.seed).key("cycles").number(result.cycles).key("time").seconds(result.time);
  if (result.ended) json.key("ended").seconds(*result.ended);
  write_requirements(json, scenario.requirements);
  json.key("expectations").open('[');
  for (std::size_t i = 0; i < result.judgements.size(); ++i) {
    const automata::Expectation& expectation = scenario.expectations[i];
    const Judgement& judgement = result.judgements[i];
    json.open('{').key("text").string(expectation.text).key("verdict").string(name_of(judgement.verdict));
    if (judgement.time) json.key("time").seconds(*judgement.time);
    if (!judgement.reason.empty()) json.key("reason").string(judgement.reason);
    if (!judgement.evidence.empty()) json.key("evidence").string(judgement.evidence);
    write_requirements(json, expectation.requirements);
    json.key("file").string(expectation.origin.file).key("line").number(expectation.origin.line);
    json.close('}');
  }
  json.close(']').close('}');
}

}  // namespace rmpl::runtime
