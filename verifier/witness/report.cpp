// Results as text and as JSON.
// SPDX-License-Identifier: MIT
#include "verifier/witness/report.hpp"

#include <algorithm>
#include <cstdio>

namespace rmpl::verifier {

using automata::Assignment;
using automata::Component;
using automata::Plant;
using nlohmann::ordered_json;

namespace {

/// A component that an event moved.
struct Taken {
  const Component& component;
  const automata::Mode& from;
  const automata::Mode& to;
};

std::vector<Taken> taken(const Plant& plant, const Event& before, const Event& event) {
  std::vector<Taken> result;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    if (before.modes[c] == event.modes[c]) continue;
    const Component& component = plant.components[c];
    result.push_back({component, component.modes[before.modes[c].index()], component.modes[event.modes[c].index()]});
  }
  return result;
}

ordered_json json_of(const Plant& plant, const std::vector<Assignment>& assignments) {
  ordered_json result = ordered_json::object();
  for (const Assignment& a : assignments) result[plant.variables.name(a.variable)] = plant.variables.value(a);
  return result;
}

ordered_json json_of(const Plant& plant, const Trace& trace) {
  ordered_json result = ordered_json::array();
  for (std::size_t e = 0; e < trace.size(); ++e) {
    ordered_json moved = ordered_json::object();
    for (const Taken& t : taken(plant, trace[e == 0 ? 0 : e - 1], trace[e])) {
      moved[t.component.name] = {{"from", t.from.name}, {"to", t.to.name}};
    }
    result.push_back({{"time", trace[e].time.seconds()},
                      {"modes", json_of(plant, automata::assignments_of(plant, trace[e].modes))},
                      {"command", json_of(plant, automata::commanded(plant, trace[e].action))},
                      {"taken", std::move(moved)}});
  }
  return result;
}

std::string text_of(const Plant& plant, const std::vector<Assignment>& assignments) {
  std::string result;
  for (const Assignment& a : assignments) {
    result += (result.empty() ? "" : ", ") + plant.variables.name(a.variable) + " = " + plant.variables.value(a);
  }
  return result;
}

/// One line an event: the time, right-aligned; the command, if any; what changed.
std::string text_of(const Plant& plant, const Trace& trace) {
  std::size_t width = 0;
  for (const Event& event : trace) width = std::max(width, automata::format_seconds(event.time).size());
  std::string result;
  for (std::size_t e = 0; e < trace.size(); ++e) {
    const std::string time = automata::format_seconds(trace[e].time);
    result += "  " + std::string(width - time.size(), ' ') + time + " s  ";
    if (e == 0) {
      result += text_of(plant, automata::assignments_of(plant, trace[e].modes)) + "\n";
      continue;
    }
    std::string changes;
    for (const Taken& t : taken(plant, trace[e - 1], trace[e])) {
      changes += (changes.empty() ? "" : ", ") + t.component.name + ": " + t.from.name + " -> " + t.to.name;
      if (t.to.fault) changes += " (fault)";
    }
    const std::string command = text_of(plant, automata::commanded(plant, trace[e].action));
    if (!command.empty()) result += "command " + command + ": ";
    result += (changes.empty() ? "nothing changes" : changes) + "\n";
  }
  return result;
}

const std::string& name_of(const Plant& plant, const Fault& fault) {
  return plant[fault.component].modes[fault.mode.index()].name;
}

std::string text_of_cut_sets(const Plant& plant, const CheckOptions& options, const Result& result) {
  if (result.verdict == Verdict::undecided) return "";
  const std::string most = options.faults == 1U ? "1 fault" : std::to_string(options.faults.value()) + " faults";
  std::string text = "minimal cut sets of up to " + most + ": " + std::to_string(result.cut_sets.size()) + "\n";
  for (const FaultTrace& cut : result.cut_sets) {
    text += "\ncut set:";
    for (std::size_t f = 0; f < cut.faults.size(); ++f) {
      text += (f == 0 ? " " : ", ") + plant[cut.faults[f].component].name + " = " + name_of(plant, cut.faults[f]);
    }
    text += (cut.faults.empty() ? " no fault is needed\n" : "\n") + text_of(plant, cut.trace);
  }
  return text;
}

std::string painted(std::string_view text, Verdict verdict, bool color) {
  if (!color) return std::string(text);
  const auto paint = [&](const char* code) { return std::string(code) + std::string(text) + "\033[0m"; };
  switch (verdict) {
    case Verdict::holds:
      return paint("\033[1;32m");
    case Verdict::violated:
      return paint("\033[1;31m");
    case Verdict::undecided:
      return paint("\033[1;33m");
  }
  return std::string(text);
}

std::string headline(const Property& property, const Result& result) {
  if (result.verdict == Verdict::undecided) return reason(result);
  const bool witness = result.trace.has_value();
  if (std::holds_alternative<Reachability>(property)) {
    return witness ? "the target is reachable" : "the target is unreachable";
  }
  if (std::holds_alternative<Safety>(property)) {
    return witness ? "what is never to hold can hold" : "what is never to hold cannot hold";
  }
  return witness ? "the response can be missed" : "the response is never missed";
}

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", seconds);
  return text;
}

std::string_view limit_text(Limit limit) {
  switch (limit) {
    case Limit::states:
      return "the limit of states (--max-states) was reached";
    case Limit::time:
      return "the limit of time (--timeout) was reached";
    case Limit::memory:
      return "the limit of memory (--max-memory) was reached";
    case Limit::interrupt:
      return "interrupted";
  }
  return "";
}

}  // namespace

std::string_view to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::violated:
      return "violated";
    case Verdict::undecided:
      return "undecided";
  }
  return "";
}

std::string reason(const Result& result) {
  if (!result.limit) return "";
  const Progress& p = result.progress;
  std::string text = std::string(limit_text(*result.limit)) + " after " + std::to_string(p.states) + " states, " +
                     std::to_string(p.waiting) + " of them unexplored";
  if (p.steps) text += "; everything within " + std::to_string(*p.steps) + " steps was seen";
  if (p.level > 0) text += "; every run with fewer than " + std::to_string(p.level) + " faults was seen";
  return text;
}

ordered_json to_json(const Plant& plant, const Property& property, const CheckOptions& options, const Result& result) {
  ordered_json json = {{"property", name_of(property)}, {"verdict", to_text(result.verdict)}};
  if (result.limit) json["reason"] = reason(result);
  json["trace"] = result.trace ? json_of(plant, *result.trace) : ordered_json::array();
  if (result.fewest_faults) json["fewest_faults"] = *result.fewest_faults;
  if (options.cut_sets) {
    auto& sets = json["cut_sets"] = ordered_json::array();
    for (const FaultTrace& cut : result.cut_sets) {
      auto faults = ordered_json::array();
      for (const Fault& f : cut.faults) {
        faults.push_back({{"component", plant[f.component].name}, {"mode", name_of(plant, f)}});
      }
      sets.push_back({{"faults", std::move(faults)}, {"trace", json_of(plant, cut.trace)}});
    }
  }
  json["statistics"] = {
      {"states", result.progress.states}, {"seconds", result.progress.seconds}, {"peak_bytes", peak_bytes()}};
  return json;
}

std::string to_text(const Plant& plant, const Property& property, const CheckOptions& options, const Result& result,
                    bool statistics, bool color) {
  std::string text = name_of(property) + ": " + painted(to_text(result.verdict), result.verdict, color) + " (" +
                     headline(property, result) + ")\n";
  if (options.cut_sets) {
    text += text_of_cut_sets(plant, options, result);
  } else if (result.trace) {
    if (result.fewest_faults) text += "fewest faults: " + std::to_string(*result.fewest_faults) + "\n";
    text += text_of(plant, *result.trace);
  }
  if (result.trace && result.limit) text += "a better trace may exist: " + reason(result) + "\n";
  if (statistics) {
    text += "states " + std::to_string(result.progress.states) + ", seconds " + seconds_text(result.progress.seconds) +
            ", peak bytes " + std::to_string(peak_bytes()) + "\n";
  }
  return text;
}

}  // namespace rmpl::verifier
