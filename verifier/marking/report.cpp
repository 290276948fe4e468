// Answers about model programs.
// SPDX-License-Identifier: MIT
#include "verifier/marking/report.hpp"

#include <algorithm>
#include <optional>

#include "automata/assignment_text.hpp"
#include "automata/step/marking_rules.hpp"
#include "base/junit.hpp"
#include "verifier/verdict/question_json.hpp"
#include "verifier/verdict/report.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::ModelProgram;
using automata::Ticks;
using nlohmann::ordered_json;

namespace {

/// The question as it would be asked of a plant; for the words.
Property property_of(const MarkingQuestion& question) {
  if (question.kind == MarkingQuestion::Kind::safety) return Safety{question.formula, question.window, false};
  return Reachability{question.formula, question.window, false};
}

/// What is said of a verdict, likewise.
Answer words_of(const MarkingAnswer& answer) {
  Answer result;
  result.verdict = answer.verdict;
  if (answer.witness) result.witness.emplace();
  result.limit = answer.limit;
  if (answer.vacuous) result.vacuous = Vacuity::unsatisfiable;
  result.cut_off.stuck = answer.stuck;
  result.progress = answer.progress;
  return result;
}

Ticks time_of(const MarkingQuestion& question, std::size_t event) {
  return {question.period.count * static_cast<std::int64_t>(event)};
}

/// The controls that are off their idle value; of those without a default, those that are known.
std::vector<Assignment> off_idle(const ModelProgram& program, const automata::Command& command) {
  std::vector<Assignment> result;
  for (std::size_t c = 0; c < command.size(); ++c) {
    const automata::CommandedVariable& control = program.controls[c];
    if (command[c] && command[c] != control.idle) result.push_back({control.variable, *command[c]});
  }
  return result;
}

/// `camera: off -> on`; what is not entailed is `?`.
std::string changes_text(const ModelProgram& program, const MarkingEvent& before, const MarkingEvent& event) {
  std::vector<std::optional<automata::ValueId>> was(program.variables.size()), is(program.variables.size());
  for (const Assignment& a : before.values) was[a.variable.index()] = a.value;
  for (const Assignment& a : event.values) is[a.variable.index()] = a.value;
  const auto name = [&](std::size_t v, std::optional<automata::ValueId> value) {
    return value ? program.variables.value({automata::VariableId(v), *value}) : std::string("?");
  };
  std::string result;
  for (std::size_t v = 0; v < was.size(); ++v) {
    if (was[v] == is[v]) continue;
    result += (result.empty() ? "" : ", ") + program.variables.name(automata::VariableId(v)) + ": " + name(v, was[v]) +
              " -> " + name(v, is[v]);
  }
  return result.empty() ? "nothing that is entailed changes" : result;
}

std::string draws_text(const ModelProgram& program, const MarkingEvent& event) {
  std::string result;
  for (const ImprobableDraw& draw : event.draws) {
    const automata::ModelLocation& location = program.locations[draw.location.index()];
    result += (result.empty() ? "; improbable: " : ", ") + location.label + in_brackets(location.origin) + " with " +
              ordered_json(draw.probability).dump();
  }
  return result;
}

std::string trace_text(const ModelProgram& program, const MarkingQuestion& question, const MarkingWitness& witness) {
  std::vector<std::string> times;
  std::size_t width = 0;
  for (std::size_t e = 0; e < witness.events.size(); ++e) {
    times.push_back(automata::format_seconds(time_of(question, e)));
    width = std::max(width, times.back().size());
  }
  std::string result;
  for (std::size_t e = 0; e < witness.events.size(); ++e) {
    const MarkingEvent& event = witness.events[e];
    const std::string command = automata::to_text(program.variables, off_idle(program, event.command));
    result.append(2 + width - times[e].size(), ' ');
    result += times[e] + " s  ";
    if (e == 0) {
      result += "the start" + std::string(event.values.empty() ? "" : ": ") +
                automata::to_text(program.variables, event.values);
    } else {
      result +=
          (command.empty() ? "" : "command " + command + ": ") + changes_text(program, witness.events[e - 1], event);
    }
    result += draws_text(program, event) + "\n";
  }
  return result;
}

ordered_json names_of(const ModelProgram& program, const std::vector<Assignment>& assignments) {
  ordered_json result = ordered_json::object();
  for (const Assignment& a : assignments) result[program.variables.name(a.variable)] = program.variables.value(a);
  return result;
}

ordered_json location_json(const ModelProgram& program, automata::LocationId id) {
  const automata::ModelLocation& location = program.locations[id.index()];
  ordered_json entry = {{"location", id.index() + 1}, {"label", location.label}};
  if (location.origin.line > 0) entry["place"] = to_text(location.origin);
  return entry;
}

ordered_json trace_json(const ModelProgram& program, const MarkingQuestion& question, const MarkingWitness& witness) {
  const automata::MarkingRules rules(program);
  ordered_json result = ordered_json::array();
  for (std::size_t e = 0; e < witness.events.size(); ++e) {
    const MarkingEvent& event = witness.events[e];
    ordered_json marking = ordered_json::array();
    for (const automata::LocationId l : rules.whole(event.marking)) marking.push_back(location_json(program, l));
    ordered_json draws = ordered_json::array();
    for (const ImprobableDraw& draw : event.draws) {
      ordered_json entry = location_json(program, draw.location);
      entry["probability"] = draw.probability;
      draws.push_back(std::move(entry));
    }
    result.push_back({{"time", time_of(question, e).seconds()},
                      {"marking", std::move(marking)},
                      {"values", names_of(program, event.values)},
                      {"command", names_of(program, off_idle(program, event.command))},
                      {"improbable", std::move(draws)}});
  }
  return result;
}

std::size_t draws_in(const MarkingWitness& witness) {
  std::size_t result = 0;
  for (const MarkingEvent& event : witness.events) result += event.draws.size();
  return result;
}

ordered_json question_of(const ModelProgram& program, const MarkingQuestion& question) {
  automata::Plant names;  // formulas are told with these
  names.variables = program.variables;
  return question_json(names, Question{property_of(question),
                                       {.period = question.period,
                                        .faults = question.improbable,
                                        .commands = question.commands,
                                        .entailed = question.entailed,
                                        .fewest_faults = question.fewest_improbable,
                                        .from = {}},
                                       question.bounds});
}

}  // namespace

std::string to_text(const ModelProgram& program, const MarkingQuestion& question, const MarkingAnswer& answer,
                    bool color) {
  const Property property = property_of(question);
  std::string text =
      name_of(property) + ": " + painted(answer.verdict, color) + " (" + meaning(property, words_of(answer)) + ")\n";
  if (!answer.witness) return text;
  if (question.fewest_improbable)
    text += "fewest improbable draws: " + std::to_string(draws_in(*answer.witness)) + "\n";
  return text + trace_text(program, question, *answer.witness);
}

ordered_json to_json(const ModelProgram& program, const MarkingQuestion& question, const MarkingAnswer& answer) {
  ordered_json json = {{"property", name_of(property_of(question))},
                       {"question", question_of(program, question)},
                       {"verdict", to_text(answer.verdict)}};
  if (answer.vacuous) json["vacuous"] = true;
  if (const std::string why = reason(words_of(answer)); !why.empty()) json["reason"] = why;
  if (answer.stuck) json["cut_off"] = "stuck";
  json["trace"] = answer.witness ? trace_json(program, question, *answer.witness) : ordered_json::array();
  if (answer.witness && question.fewest_improbable) json["fewest_faults"] = draws_in(*answer.witness);
  json["statistics"] = statistics_of(answer.progress);
  return json;
}

std::string to_junit(const ModelProgram& program, const MarkingQuestion& question, const MarkingAnswer& answer,
                     const std::string& title) {
  const std::string text = to_text(program, question, answer, false);
  const std::size_t headline = text.find('\n');
  using Outcome = base::TestCase::Outcome;
  const base::TestCase one{.name = title,
                           .classname = program.name + "." + name_of(property_of(question)),
                           .seconds = answer.progress.seconds,
                           .outcome = answer.verdict == Verdict::holds      ? Outcome::success
                                      : answer.verdict == Verdict::violated ? Outcome::failure
                                                                            : Outcome::error,
                           .message = text.substr(0, headline),
                           .text = text.substr(headline + 1),
                           .notes = notes(words_of(answer))};
  return base::to_junit(program.name, std::vector{one});
}

}  // namespace rmpl::verifier
