// Every fault by itself: what may come of it, as text, as JSON and as JUnit XML.
// SPDX-License-Identifier: MIT
#include "verifier/verdict/fault_table.hpp"

#include <algorithm>
#include <array>

#include "base/junit.hpp"
#include "verifier/verdict/question_json.hpp"
#include "verifier/verdict/report.hpp"
#include "verifier/verdict/trace.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::verifier {

using nlohmann::ordered_json;

namespace {

constexpr const char* mission_lost = "mission lost";
constexpr const char* waits_for_ever = "program waits for ever";
constexpr const char* another_certain = "another fault is certain";
constexpr const char* goes_on_for_ever = "program goes on for ever";

/// `valve: open -> stuck`, or `none`.
std::string name_of(const Subject& subject, const FaultOutcome& row) {
  if (!row.fault) return "none";
  const automata::Component& component = subject.plant[row.fault->component];
  return component.name + ": " + component.modes[row.fault->from.index()].name + " -> " +
         component.modes[row.fault->to.index()].name;
}

bool cannot_happen(const FaultOutcome& row) { return row.decided && row.fault && !row.happens; }

}  // namespace

std::vector<std::string> outcomes_of(const FaultOutcome& row) {
  if (cannot_happen(row)) return {"cannot happen"};
  std::vector<std::string> result;
  if (row.success) result.emplace_back(row.fault ? "recovered" : "success");
  if (row.spoils()) result.emplace_back("never recovered");
  if (row.unrepaired) result.emplace_back("never repaired");
  const auto add = [&](bool comes, bool anyway, const std::string& words) {
    if (comes) result.push_back(words + (anyway && row.fault ? " anyway" : ""));
  };
  add(row.lost.has_value(), row.anyway.lost, mission_lost);
  add(row.waits.has_value(), row.anyway.waits, waits_for_ever);
  add(row.goes_on.has_value(), row.anyway.goes_on, goes_on_for_ever);
  if (row.stops) add(true, row.anyway.stops, row.stops->stop->still ? "time stands still" : "stuck");
  add(row.another.has_value(), row.anyway.another, row.fault ? another_certain : "a fault is certain");
  if (!row.decided) result.emplace_back("undecided");
  // All runs lead out of the question.
  if (result.empty()) result.emplace_back(another_certain);
  return result;
}

namespace {

std::string outcome_text(const FaultOutcome& row) {
  std::string result;
  for (const std::string& outcome : outcomes_of(row)) result += (result.empty() ? "" : ", ") + outcome;
  return result;
}

/// ` (no plan: …)`, where a goal is without one.
std::string no_plan_text(const FaultOutcome& row) {
  return row.no_plan ? " (no plan: " + row.no_plan->events.back().cycle->reason + ")" : "";
}

/// When the fault may happen at the earliest.
std::optional<std::string> earliest_of(const FaultOutcome& row) {
  if (!row.happens) return std::nullopt;
  return automata::format_seconds(row.happens->events.back().time) + " s";
}

/// The run on which the mission is lost, or else the program does not end; empty where there is none.
std::string failure_text(const Subject& subject, const FaultOutcome& row) {
  if (row.lost) return text_of(subject, *row.lost, mission_lost);
  if (row.waits) return text_of(subject, *row.waits, waits_for_ever);
  if (row.goes_on) return text_of(subject, *row.goes_on, goes_on_for_ever);
  if (row.stops) return text_of(subject, *row.stops, to_text(subject.plant, *row.stops->stop));
  return row.another ? text_of(subject, *row.another, another_certain) : "";
}

}  // namespace

ordered_json to_json(const Subject& subject, const ProgramQuestion& question, const FaultTable& table) {
  ordered_json asked = question_json(subject.plant, question);
  asked["faults"] = 1;
  asked["mission"] = ordered_json::array();
  for (const Property& property : question.properties) {
    ordered_json claim = {{"property", name_of(property)}};
    claim.update(claim_of(subject.plant, property));
    asked["mission"].push_back(std::move(claim));
  }
  ordered_json json = {{"property", "each-fault"}, {"question", std::move(asked)}, {"faults", ordered_json::array()}};
  if (table.limit) json["reason"] = reason(table.limit, table.progress);
  if (!table.warnings.empty()) json["warnings"] = table.warnings;
  for (const FaultOutcome& row : table.rows) {
    ordered_json entry = ordered_json::object();
    if (row.fault) {
      const automata::Component& component = subject.plant[row.fault->component];
      entry = {{"component", component.name},
               {"from", component.modes[row.fault->from.index()].name},
               {"to", component.modes[row.fault->to.index()].name}};
    }
    entry["outcomes"] = outcomes_of(row);
    if (row.decided) entry["no_plan"] = row.no_plan.has_value();
    entry["traces"] = ordered_json::object();
    const auto add = [&](const char* name, const std::optional<Witness>& witness) {
      if (witness) entry["traces"][name] = json_of(subject, *witness);
    };
    add("happens", row.happens);
    add("success", row.success);
    add("lost", row.lost);
    add("waits", row.waits);
    add("goes_on", row.goes_on);
    add("stops", row.stops);
    add("another", row.another);
    add("no_plan", row.no_plan);
    json["faults"].push_back(std::move(entry));
  }
  json["statistics"] = statistics_of(table.progress);
  return json;
}

std::string to_text(const Subject& subject, const FaultTable& table) {
  std::vector<std::array<std::string, 3>> rows = {{"fault", "earliest", "what can come of it"}};
  for (const FaultOutcome& row : table.rows) {
    const auto earliest = earliest_of(row);
    rows.push_back({name_of(subject, row), earliest ? *earliest : "-", outcome_text(row) + no_plan_text(row)});
  }
  std::array<std::size_t, 2> widths{};
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    text += row[0] + std::string(widths[0] - row[0].size() + 2, ' ') + std::string(widths[1] - row[1].size(), ' ') +
            row[1] + "  " + row[2] + "\n";
  }
  if (table.limit) text += reason(table.limit, table.progress) + "\n";
  return text;
}

std::string to_junit(const Subject& subject, const FaultTable& table) {
  using enum base::TestCase::Outcome;
  std::vector<base::TestCase> cases;
  for (const FaultOutcome& row : table.rows) {
    const std::string outcome = outcome_text(row) + no_plan_text(row);
    const auto earliest = earliest_of(row);
    std::string notes = earliest ? "the fault happens at " + *earliest + " at the earliest\n" : "";
    // Of a failure the message says it.
    if (row.decided && !row.fails()) notes += outcome + "\n";
    cases.push_back({.name = name_of(subject, row),
                     .classname = subject.plant.name + "." + subject.program->name,
                     .seconds = cases.empty() ? table.progress.seconds : 0.0,
                     .outcome = row.fails()          ? failure
                                : !row.decided       ? error
                                : cannot_happen(row) ? skipped
                                                     : success,
                     .message = outcome,
                     .text = failure_text(subject, row),
                     .notes = cannot_happen(row) ? "" : std::move(notes)});
  }
  for (const std::string& warning : table.warnings) cases.front().notes += "warning: " + warning + "\n";
  return base::to_junit(title(subject), cases);
}

}  // namespace rmpl::verifier
