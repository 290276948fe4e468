// Results about programs as text and as JSON.
// SPDX-License-Identifier: MIT
#include "verifier/closed_loop/program_report.hpp"

#include <algorithm>
#include <cstdio>

#include "verifier/witness/report.hpp"

namespace rmpl::verifier {

using automata::Assignment;
using automata::LocationId;
using automata::Ticks;
using nlohmann::ordered_json;
using Kind = ProgramProperty::Kind;

namespace {

std::string place(const automata::Origin& origin) {
  return origin.file + ":" + std::to_string(origin.line) + ":" + std::to_string(origin.column);
}

/// `text (file:line:column)`, where there is a source.
std::string placed(const std::string& text, const automata::Origin& origin) {
  return origin.line == 0 ? text : text + " (" + place(origin) + ")";
}

std::string text_of(const automata::Plant& plant, Assignment a) {
  return plant.variables.name(a.variable) + " = " + plant.variables.value(a);
}

std::string text_of(const automata::Plant& plant, const std::vector<Assignment>& assignments) {
  std::string result;
  for (const Assignment& a : assignments) result += (result.empty() ? "" : ", ") + text_of(plant, a);
  return result;
}

/// The goals with the lines that assert them.
std::string goal_text(const ProgramSubject& subject, const LoopCycle& cycle) {
  std::string result;
  for (const Assignment& goal : cycle.goal) {
    const auto asserts = [&](LocationId id) {
      const auto& own = subject.program.locations[id.index()].goal;
      return std::find(own.begin(), own.end(), goal) != own.end();
    };
    const auto at = std::find_if(cycle.marking.begin(), cycle.marking.end(), asserts);
    const std::string text = text_of(subject.plant, goal);
    const bool known = at != cycle.marking.end();
    result += result.empty() ? "" : ", ";
    result += known ? placed(text, subject.program.locations[at->index()].origin) : text;
  }
  return result;
}

std::string changes_text(const automata::Plant& plant, const automata::Modes& before, const automata::Modes& after) {
  std::string result;
  for (std::size_t c = 0; c < after.size(); ++c) {
    if (before[c] == after[c]) continue;
    const automata::Component& component = plant.components[c];
    const automata::Mode& to = component.modes[after[c].index()];
    if (!result.empty()) result += ", ";
    result += component.name + ": " + component.modes[before[c].index()].name + " -> " + to.name;
    if (to.fault) result += " (fault)";
  }
  return result;
}

/// The lines of a trace: a time, and what there is to say.
class Story {
 public:
  Story(const ProgramSubject& subject, const LoopTrace& trace) : subject_(subject), trace_(trace) {}

  std::string tell(const std::string& end) {
    line(Ticks{0}, text_of(subject_.plant, automata::assignments_of(subject_.plant, trace_.start)));
    const automata::Modes* modes = &trace_.start;
    Ticks since{0};
    for (std::size_t i = 0; i < trace_.cycles.size(); ++i) {
      const LoopCycle& cycle = trace_.cycles[i];
      if (trace_.repeats_from == i) line(since, "from here on it repeats:");
      tell_goal(cycle, since);
      tell_step(cycle, *modes);
      modes = &cycle.modes;
      since = cycle.end;
    }
    tell_goal(trace_.last, since);
    line(trace_.last.begin, end);
    std::size_t width = 0;
    for (const auto& [time, text] : lines_) width = std::max(width, time.size());
    std::string result;
    for (const auto& [time, text] : lines_) {
      result.append(2 + width - time.size(), ' ');
      result += time;
      result += " s  ";
      result += text;
      result += '\n';
    }
    return result;
  }

 private:
  void line(Ticks time, const std::string& text) { lines_.emplace_back(automata::format_seconds(time), text); }

  /// `since`: the end of the cycle before. All from there on assert the same.
  void tell_goal(const LoopCycle& cycle, Ticks since) {
    if (cycle.goal == goal_) return;
    goal_ = cycle.goal;
    if (!goal_.empty()) line(since, "goal " + goal_text(subject_, cycle));
  }

  void tell_step(const LoopCycle& cycle, const automata::Modes& before) {
    const std::string changes = changes_text(subject_.plant, before, cycle.modes);
    const std::string command = text_of(subject_.plant, automata::commanded(subject_.plant, cycle.action));
    const bool repeated = changes.empty() && cycle.action == command_;
    command_ = cycle.action;
    if ((changes.empty() && command.empty()) || repeated) return;
    line(cycle.end,
         (command.empty() ? "" : "command " + command + ": ") + (changes.empty() ? "nothing changes" : changes));
  }

  const ProgramSubject& subject_;
  const LoopTrace& trace_;
  std::vector<Assignment> goal_;
  automata::ControlAction command_;
  std::vector<std::pair<std::string, std::string>> lines_;
};

ordered_json json_of(const automata::Plant& plant, const std::vector<Assignment>& assignments) {
  ordered_json result = ordered_json::object();
  for (const Assignment& a : assignments) result[plant.variables.name(a.variable)] = plant.variables.value(a);
  return result;
}

ordered_json json_of(const automata::Program& program, const automata::Marking& marking) {
  ordered_json result = ordered_json::array();
  for (const LocationId id : marking) {
    const automata::Location& location = program.locations[id.index()];
    ordered_json entry = {{"location", id.index() + 1}, {"label", location.label}};
    if (location.origin.line > 0) entry["place"] = place(location.origin);
    result.push_back(std::move(entry));
  }
  return result;
}

ordered_json json_of(const ProgramSubject& subject, const LoopTrace& trace) {
  const automata::Plant& plant = subject.plant;
  ordered_json result = ordered_json::array();
  const auto event = [&](const LoopCycle& cycle, Ticks time, const automata::Modes& before,
                         const automata::Modes& after) {
    ordered_json taken = ordered_json::object();
    for (std::size_t c = 0; c < after.size(); ++c) {
      if (before[c] == after[c]) continue;
      const auto& modes = plant.components[c].modes;
      taken[plant.components[c].name] = {{"from", modes[before[c].index()].name}, {"to", modes[after[c].index()].name}};
    }
    result.push_back({{"time", time.seconds()},
                      {"modes", json_of(plant, automata::assignments_of(plant, after))},
                      {"command", json_of(plant, automata::commanded(plant, cycle.action))},
                      {"taken", std::move(taken)},
                      {"start", cycle.begin.seconds()},
                      {"marking", json_of(subject.program, cycle.marking)},
                      {"goal", json_of(plant, cycle.goal)}});
  };
  const automata::Modes* modes = &trace.start;
  const LoopCycle& first = trace.cycles.empty() ? trace.last : trace.cycles.front();
  result.push_back({{"time", 0.0},
                    {"modes", json_of(plant, automata::assignments_of(plant, trace.start))},
                    {"command", ordered_json::object()},
                    {"taken", ordered_json::object()},
                    {"start", 0.0},
                    {"marking", json_of(subject.program, first.marking)},
                    {"goal", ordered_json::object()}});
  for (const LoopCycle& cycle : trace.cycles) {
    event(cycle, cycle.end, *modes, cycle.modes);
    modes = &cycle.modes;
  }
  event(trace.last, trace.last.begin, *modes, *modes);
  return result;
}

ordered_json statistics_of(const Progress& progress) {
  return {{"states", progress.states}, {"seconds", progress.seconds}, {"peak_bytes", peak_bytes()}};
}

std::string reason_of(std::optional<Limit> limit, const Progress& progress) {
  Result result;
  result.limit = limit;
  result.progress = progress;
  return reason(result);
}

std::string statistics_text(const Progress& progress) {
  char text[96];
  std::snprintf(text, sizeof text, "%zu states, %.3f s, %.1f MiB\n", progress.states, progress.seconds,
                static_cast<double>(peak_bytes()) / (1024 * 1024));
  return text;
}

std::string painted(std::string_view text, Verdict verdict, bool color) {
  if (!color) return std::string(text);
  const char* code = verdict == Verdict::holds ? "32" : verdict == Verdict::violated ? "31" : "33";
  return "\033[1;" + std::string(code) + "m" + std::string(text) + "\033[0m";
}

/// What a verdict about a property means.
std::string meaning(const ProgramProperty& property, Verdict verdict) {
  const bool violated = verdict == Verdict::violated;
  switch (property.kind) {
    case Kind::goal_conflict:
      return violated ? "goals that contradict each other can be asserted together"
                      : "goals that are asserted together never contradict each other";
    case Kind::no_plan:
      return violated ? "a goal can be without a plan" : "there is a plan for every goal";
    case Kind::endless_wait:
      return violated ? "the program can wait for ever" : "no wait lasts for ever";
    case Kind::termination:
      return violated ? "the program can go on for ever" : "the program ends on every run";
    case Kind::never:
      return "'" + property.text + "' " + (violated ? "can hold" : "never holds");
    case Kind::eventually:
      return "'" + property.text + "' " + (violated ? "can come too late, or never" : "always comes") + " within " +
             automata::format_seconds(property.within) + " s";
    case Kind::finally:
      return violated ? "the program can end without '" + property.text + "'"
                      : "'" + property.text + "' holds wherever the program ends";
  }
  return "";
}

}  // namespace

std::string title(const ProgramSubject& subject) { return subject.program.name + " on " + subject.plant.name; }

std::string finding(const ProgramSubject& subject, const ProgramProperty& property, const LoopTrace& trace) {
  const auto location = [&](LocationId id) -> const automata::Location& {
    return subject.program.locations[id.index()];
  };
  switch (property.kind) {
    case Kind::goal_conflict: {
      const automata::GoalConflict& conflict = trace.last.conflicts.front();
      return "goals contradict each other: " +
             placed(text_of(subject.plant, conflict.contradicted), location(conflict.first).origin) + " and " +
             placed(text_of(subject.plant, conflict.asserted), location(conflict.second).origin);
    }
    case Kind::no_plan:
      return "no plan: " + trace.last.reason;
    case Kind::termination:
    case Kind::endless_wait: {
      if (trace.repeats_from) return "and so on, for ever";
      std::string waiting;
      for (const LocationId id : trace.last.marking) {
        if (location(id).composite) continue;
        waiting += (waiting.empty() ? "" : ", ") + placed("`" + location(id).label + "`", location(id).origin);
      }
      return "nothing but a fault would change anything any more; the program waits at " + waiting;
    }
    case Kind::never:
      return "'" + property.text + "' can hold";
    case Kind::eventually:
      return "'" + property.text + "' has not held in time";
    case Kind::finally:
      return "the program has ended, and '" + property.text + "' need not hold";
  }
  return "";
}

ordered_json to_json(const ProgramSubject& subject, const std::vector<ProgramProperty>& properties,
                     const ProgramResult& result) {
  ordered_json json = {{"property", "program"}, {"verdict", to_text(result.verdict())}};
  if (result.limit) json["reason"] = reason_of(result.limit, result.progress);
  json["trace"] = ordered_json::array();
  json["checks"] = ordered_json::array();
  for (std::size_t p = 0; p < properties.size(); ++p) {
    const ProgramAnswer& answer = result.answers[p];
    ordered_json check = {{"property", name_of(properties[p].kind)}, {"verdict", to_text(answer.verdict)}};
    if (!properties[p].text.empty()) check["formula"] = properties[p].text;
    if (properties[p].kind == Kind::eventually) check["within"] = properties[p].within.seconds();
    if (answer.trace) {
      check["finding"] = finding(subject, properties[p], *answer.trace);
      check["trace"] = json_of(subject, *answer.trace);
      // The state after the start of the loop, in the list above.
      if (answer.trace->repeats_from) check["repeats_from"] = *answer.trace->repeats_from + 1;
      if (json["trace"].empty()) json["trace"] = check["trace"];
    }
    json["checks"].push_back(std::move(check));
  }
  json["statistics"] = statistics_of(result.progress);
  return json;
}

std::string to_text(const ProgramSubject& subject, const std::vector<ProgramProperty>& properties,
                    const ProgramResult& result, bool statistics, bool color) {
  std::string text;
  for (std::size_t p = 0; p < properties.size(); ++p) {
    const ProgramAnswer& answer = result.answers[p];
    const std::string what = answer.verdict == Verdict::undecided ? reason_of(result.limit, result.progress)
                                                                  : meaning(properties[p], answer.verdict);
    text += std::string(name_of(properties[p].kind)) + ": " + painted(to_text(answer.verdict), answer.verdict, color) +
            " (" + what + ")\n";
    if (answer.trace) text += Story(subject, *answer.trace).tell(finding(subject, properties[p], *answer.trace));
  }
  if (statistics) text += statistics_text(result.progress);
  return text;
}

std::string name_of(const ProgramSubject& subject, const FaultOutcome& row) {
  if (!row.fault) return "none";
  const automata::Component& component = subject.plant[row.fault->component];
  return component.name + ": " + component.modes[row.fault->from.index()].name + " -> " +
         component.modes[row.fault->to.index()].name;
}

std::string failure_text(const ProgramSubject& subject, const FaultOutcome& row) {
  const std::vector<std::string> words = outcomes_of(row);
  const auto* const trace = row.lost ? &row.lost : row.waits ? &row.waits : &row.goes_on;
  if (!*trace) return "";
  const std::size_t success = row.success ? 1 : 0;
  return Story(subject, **trace).tell(words[success]);
}

std::vector<std::string> outcomes_of(const FaultOutcome& row) {
  if (!row.decided) return {"undecided"};
  if (row.fault && !row.happens) return {"cannot happen"};
  std::vector<std::string> result;
  if (row.success) result.emplace_back(row.fault ? "recovered" : "success");
  if (row.lost) result.emplace_back("mission lost");
  if (row.waits) result.emplace_back("program waits for ever");
  if (row.goes_on) result.emplace_back("program goes on for ever");
  return result;
}

ordered_json to_json(const ProgramSubject& subject, const FaultTable& table) {
  ordered_json json = {{"property", "each-fault"}, {"faults", ordered_json::array()}};
  if (table.limit) json["reason"] = reason_of(table.limit, table.progress);
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
    const auto add = [&](const char* name, const std::optional<LoopTrace>& trace) {
      if (trace) entry["traces"][name] = json_of(subject, *trace);
    };
    add("happens", row.happens);
    add("success", row.success);
    add("lost", row.lost);
    add("waits", row.waits);
    add("goes_on", row.goes_on);
    add("no_plan", row.no_plan);
    json["faults"].push_back(std::move(entry));
  }
  json["statistics"] = statistics_of(table.progress);
  return json;
}

std::string to_text(const ProgramSubject& subject, const FaultTable& table, bool statistics) {
  std::vector<std::array<std::string, 3>> rows = {{"fault", "earliest", "what can come of it"}};
  for (const FaultOutcome& row : table.rows) {
    std::string outcome;
    for (const std::string& part : outcomes_of(row)) outcome += (outcome.empty() ? "" : ", ") + part;
    if (row.no_plan) outcome += " (no plan: " + row.no_plan->last.reason + ")";
    rows.push_back(
        {name_of(subject, row), row.happens ? automata::format_seconds(row.happens->last.begin) + " s" : "-", outcome});
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
  if (table.limit) text += reason_of(table.limit, table.progress) + "\n";
  if (statistics) text += statistics_text(table.progress);
  return text;
}

}  // namespace rmpl::verifier
