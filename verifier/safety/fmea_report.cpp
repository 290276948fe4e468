// FMEA tables as text, JSON, CSV and HTML.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>

#include "automata/assignment_text.hpp"
#include "base/xml_text.hpp"
#include "verifier/safety/fmea.hpp"
#include "verifier/verdict/report.hpp"
#include "verifier/verdict/wording.hpp"

namespace rmpl::verifier {

using automata::Plant;
using nlohmann::ordered_json;

namespace {

std::string joined(const std::vector<std::string>& parts, const char* separator) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : separator) + part;
  return text;
}

std::string value_text(const Plant& plant, automata::VariableId variable,
                       const std::optional<automata::ValueId>& value) {
  return value ? plant.variables[variable].values[value->index()] : "open";
}

/// A row as its columns, in words.
struct Columns {
  std::string item, local, next, end, checks, detection, response, severity, probability, criticality;
};

std::string after_text(automata::Ticks after) {
  return after == automata::Ticks{} ? "in the same cycle" : "after " + automata::format_seconds(after) + " s";
}

std::string change_text(const Plant& plant, automata::VariableId variable, const std::optional<automata::ValueId>& from,
                        const std::optional<automata::ValueId>& to) {
  return plant.variables.name(variable) + ": " + value_text(plant, variable, from) + " -> " +
         value_text(plant, variable, to);
}

/// What the fault changes at once, and what it has changed later in the flight.
std::string next_text(const Plant& plant, const FailureMode& row) {
  std::vector<std::string> parts;
  for (const EffectChange& change : row.next)
    parts.push_back(change_text(plant, change.variable, change.before, change.after));
  for (const LaterEffect& effect : row.flown ? row.flown->effects : std::vector<LaterEffect>{}) {
    const bool told = std::any_of(row.next.begin(), row.next.end(),
                                  [&](const EffectChange& change) { return change.variable == effect.variable; });
    if (told) continue;
    parts.push_back(change_text(plant, effect.variable, effect.without, effect.with) +
                    (effect.after == automata::Ticks{} ? "" : " " + after_text(effect.after)));
  }
  return parts.empty() ? "none" : joined(parts, "; ");
}

std::string checks_text(const FailureMode& row) {
  std::vector<std::string> violated, anyway;
  for (const CheckedEffect& check : row.checks) {
    if (check.violated) (check.anyway ? anyway : violated).push_back(check.check);
  }
  if (row.checks.empty()) return "none";
  const std::string all = std::to_string(row.checks.size());
  if (violated.empty() && anyway.empty()) return "all " + all + " hold";
  std::string text = violated.empty() ? "" : "violated: " + joined(violated, ", ") + "; ";
  if (!anyway.empty()) text += "violated without the fault too: " + joined(anyway, ", ") + "; ";
  return text + "of " + all;
}

/// Which readings tell it, and when the estimate has it.
std::string detection_text(const Plant& plant, const FailureMode& row) {
  if (row.flights_cut) return "not flown: the search was cut off";
  if (!row.flown) {
    if (!row.earliest && row.decided) return "none";
    std::vector<std::string> parts;
    for (const EffectChange& change : row.detected) {
      parts.push_back(plant.variables.name(change.variable) + " = " + value_text(plant, change.variable, change.after));
    }
    return parts.empty() ? "no reading is certain to show the fault" : joined(parts, "; ") + " in the same cycle";
  }
  const FlownFault& flown = *row.flown;
  std::string text = "no reading shows the fault";
  if (flown.symptom_after) text = to_text(plant.variables, flown.symptoms) + " " + after_text(*flown.symptom_after);
  text += flown.named_after ? "; estimated " + after_text(*flown.named_after) : "; never estimated";
  if (flown.taken_for) text += ", taken for " + to_text(plant.variables, {*flown.taken_for});
  return text;
}

std::string response_text(const Plant& plant, const FailureMode& row) {
  if (!row.flown) return row.response.empty() ? "none" : to_text(plant.variables, row.response);
  if (row.flown->outcome.empty()) return "none";
  if (row.flown->response.empty()) return row.flown->outcome;
  return to_text(plant.variables, row.flown->response);
}

/// How the flights with and without the fault end.
std::string flight_text(const FailureMode& row) {
  if (!row.flown) return "";
  const auto end = [](const std::optional<automata::Ticks>& time) {
    return time ? "ends at " + automata::format_seconds(*time) + " s" : std::string("does not end");
  };
  const std::string with = end(row.flown->ended), without = end(row.flown->ended_without);
  return "; in a flight to " + automata::format_seconds(row.flown->until) + " s it " + with +
         (with == without ? ", as without the fault" : ", and without the fault it " + without);
}

Columns columns_of(const Plant& plant, const FailureMode& row) {
  const automata::Component& component = plant[row.fault.component];
  Columns result;
  result.item = component.name;
  const automata::Mode& from = component.modes[row.fault.from.index()];
  const automata::Mode& to = component.modes[row.fault.to.index()];
  result.local = from.name + " -> " + to.name;
  if (!from.constraint.is_true() && from.constraint != to.constraint) {
    result.local += ": no more " + automata::to_text(from.constraint, plant.variables);
    if (!to.constraint.is_true()) result.local += ", but " + automata::to_text(to.constraint, plant.variables);
  }
  result.next = next_text(plant, row);
  result.end = joined(row.end, ", ");
  if (!row.violated.empty()) result.end += "; violates " + joined(row.violated, ", ");
  result.end += flight_text(row);
  result.checks = checks_text(row);
  result.detection = detection_text(plant, row);
  result.response = response_text(plant, row);
  result.severity = row.severity ? name_of(*row.severity) : row.fails ? "not stated" : "none";
  char number[64];
  if (row.rate) {
    std::snprintf(number, sizeof number, "%.6g /h", *row.rate);
    result.probability = number;
  }
  if (row.per_step) {
    std::snprintf(number, sizeof number, "%.6g a step", *row.per_step);
    result.probability += (result.probability.empty() ? "" : ", ") + std::string(number);
  }
  result.criticality = !row.decided   ? "undecided"
                       : row.fails    ? "fails the mission"
                       : row.earliest ? "tolerated"
                                      : "none";
  return result;
}

const std::vector<std::pair<const char*, std::string Columns::*>>& columns() {
  static const std::vector<std::pair<const char*, std::string Columns::*>> all = {
      {"item", &Columns::item},
      {"failure mode and local effect", &Columns::local},
      {"next effect", &Columns::next},
      {"end effect", &Columns::end},
      {"checks", &Columns::checks},
      {"detection", &Columns::detection},
      {"response", &Columns::response},
      {"severity", &Columns::severity},
      {"probability", &Columns::probability},
      {"criticality", &Columns::criticality}};
  return all;
}

ordered_json seconds_json(const std::optional<automata::Ticks>& time) {
  return time ? ordered_json(time->seconds()) : ordered_json(nullptr);
}

ordered_json assignments_json(const Plant& plant, const std::vector<automata::Assignment>& some) {
  ordered_json result = ordered_json::object();
  for (const automata::Assignment& one : some) {
    result[plant.variables.name(one.variable)] = plant.variables[one.variable].values[one.value.index()];
  }
  return result;
}

ordered_json value_json(const Plant& plant, automata::VariableId variable,
                        const std::optional<automata::ValueId>& one) {
  return one ? ordered_json(plant.variables[variable].values[one->index()]) : ordered_json(nullptr);
}

ordered_json checks_json(const FailureMode& row) {
  ordered_json result = ordered_json::array();
  for (const CheckedEffect& check : row.checks) {
    result.push_back(
        {{"check", check.check}, {"verdict", check.violated ? "violated" : "holds"}, {"anyway", check.anyway}});
  }
  return result;
}

ordered_json flight_json(const Plant& plant, const FlownFault& flown) {
  ordered_json effects = ordered_json::array();
  for (const LaterEffect& effect : flown.effects) {
    effects.push_back({{"variable", plant.variables.name(effect.variable)},
                       {"without", value_json(plant, effect.variable, effect.without)},
                       {"with", value_json(plant, effect.variable, effect.with)},
                       {"after", effect.after.seconds()}});
  }
  std::vector<automata::Assignment> taken_for;
  if (flown.taken_for) taken_for.push_back(*flown.taken_for);
  return {{"seed", flown.seed},
          {"happened", flown.happened.seconds()},
          {"effects", std::move(effects)},
          {"symptoms", assignments_json(plant, flown.symptoms)},
          {"symptom_after", seconds_json(flown.symptom_after)},
          {"estimated_after", seconds_json(flown.named_after)},
          {"taken_for", assignments_json(plant, taken_for)},
          {"outcome", flown.outcome.empty() ? ordered_json(nullptr) : ordered_json(flown.outcome)},
          {"response", assignments_json(plant, flown.response)},
          {"ended", seconds_json(flown.ended)},
          {"ended_without", seconds_json(flown.ended_without)},
          {"until", flown.until.seconds()}};
}

std::string in_csv(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

}  // namespace

std::string to_text(const Plant& plant, const FailureModes& table) {
  std::string text;
  for (const FailureMode& row : table.rows) {
    const Columns own = columns_of(plant, row);
    text += own.item + ": " + own.local + "\n";
    for (std::size_t c = 2; c < columns().size(); ++c) {
      text += std::string("  ") + columns()[c].first + ": " + own.*columns()[c].second + "\n";
    }
  }
  if (table.limit) text += reason(table.limit, table.progress) + "\n";
  return text;
}

ordered_json to_json(const Plant& plant, const FailureModes& table) {
  ordered_json json = {{"property", "fmea"}, {"rows", ordered_json::array()}};
  if (table.limit) json["reason"] = reason(table.limit, table.progress);
  json["flight_ended"] = seconds_json(table.ended);
  for (const FailureMode& row : table.rows) {
    const automata::Component& component = plant[row.fault.component];
    const auto changes = [&](const std::vector<EffectChange>& some) {
      ordered_json result = ordered_json::object();
      for (const EffectChange& change : some) {
        result[plant.variables.name(change.variable)] = {{"before", value_json(plant, change.variable, change.before)},
                                                         {"after", value_json(plant, change.variable, change.after)}};
      }
      return result;
    };
    json["rows"].push_back(
        {{"component", component.name},
         {"from", component.modes[row.fault.from.index()].name},
         {"to", component.modes[row.fault.to.index()].name},
         {"earliest", seconds_json(row.earliest)},
         {"local", columns_of(plant, row).local},
         {"next", changes(row.next)},
         {"end", row.end},
         {"violated", row.violated},
         {"severity", row.severity ? ordered_json(name_of(*row.severity)) : ordered_json(nullptr)},
         {"detection", changes(row.detected)},
         {"response", assignments_json(plant, row.response)},
         {"rate_per_hour", row.rate ? ordered_json(*row.rate) : ordered_json(nullptr)},
         {"probability_per_step", row.per_step ? ordered_json(*row.per_step) : ordered_json(nullptr)},
         {"fails", row.fails},
         {"decided", row.decided},
         {"checks", checks_json(row)},
         {"cut", row.flights_cut},
         {"flight", row.flown ? flight_json(plant, *row.flown) : ordered_json(nullptr)}});
  }
  json["statistics"] = statistics_of(table.progress);
  return json;
}

std::string to_csv(const Plant& plant, const FailureModes& table) {
  std::string text;
  for (const auto& [name, column] : columns()) text += (text.empty() ? "" : ",") + in_csv(name);
  text += "\r\n";
  for (const FailureMode& row : table.rows) {
    const Columns own = columns_of(plant, row);
    std::string line;
    for (const auto& [name, column] : columns()) line += (line.empty() ? "" : ",") + in_csv(own.*column);
    text += line + "\r\n";
  }
  return text;
}

std::string to_html(const Subject& subject, const FailureModes& table) {
  const std::string name = base::xml_text(title(subject));
  std::string text =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>FMEA: " + name +
      "</title>\n<style>body{font-family:\"Liberation "
      "Sans\",Arial,sans-serif;margin:2em}table{border-collapse:collapse}"
      "th,td{border:1px solid #888;padding:.3em .5em;vertical-align:top;text-align:left}th{background:#eee}"
      "tr.fails td{background:#fdeaea}</style></head>\n<body><h1>FMEA: " +
      name + "</h1>\n<table><tr>";
  for (const auto& [column, member] : columns()) text += std::string("<th>") + column + "</th>";
  text += "</tr>\n";
  for (const FailureMode& row : table.rows) {
    const Columns own = columns_of(subject.plant, row);
    text += row.fails ? "<tr class=\"fails\">" : "<tr>";
    for (const auto& [column, member] : columns()) text += "<td>" + base::xml_text(own.*member) + "</td>";
    text += "</tr>\n";
  }
  text += "</table>\n";
  if (table.limit) text += "<p>" + base::xml_text(reason(table.limit, table.progress)) + "</p>\n";
  return text + "</body></html>\n";
}

}  // namespace rmpl::verifier
