// A word for each row, then what it holds.
// SPDX-License-Identifier: MIT
#include "runtime/executive/step/stop.hpp"

#include <algorithm>
#include <utility>

#include "automata/assignment_text.hpp"
#include "automata/controls.hpp"
#include "automata/place.hpp"
#include "base/utf8.hpp"
#include "runtime/executive/scenario/moment.hpp"
#include "runtime/executive/trace/three_digits.hpp"

namespace rmpl::runtime {
namespace {

using automata::format_seconds;
using automata::Ticks;

constexpr std::size_t word_width = 10;
constexpr std::size_t width = 100;

std::string padded(std::string text, std::size_t columns) {
  const std::size_t size = base::code_points(text);
  if (size < columns) text.append(columns - size, ' ');
  return text;
}

/// A row, or several of one word.
class Rows {
 public:
  Rows(std::string& text, base::Painter painter) : text_(text), painter_(painter) {}

  void add(std::string_view word, const std::string& line) {
    text_ += "  " + painter_.note(padded(std::string(word), word_width)) + line + "\n";
  }
  /// One after the other, as many as fit into a row.
  void add_all(std::string_view word, const std::vector<std::pair<std::string, bool>>& parts) {
    std::string row;
    std::size_t used = 0;
    for (const auto& [part, bad] : parts) {
      const std::size_t size = base::code_points(part);
      if (used > 0 && word_width + 2 + used + 2 + size > width) {
        add(std::exchange(word, ""), row + ",");
        row.clear();
        used = 0;
      }
      row += (used > 0 ? ", " : "") + (bad ? painter_.bad(part) : part);
      used += size + (used > 0 ? 2 : 0);
    }
    add(word, row);
  }
  void add_lines(std::string_view word, const std::vector<Stop::Line>& lines) {
    for (const Stop::Line& line : lines) {
      add(std::exchange(word, ""), line.text + painter_.quiet(in_parentheses(line.origin)));
    }
  }

 private:
  std::string& text_;
  base::Painter painter_;
};

std::vector<std::pair<std::string, bool>> parts_of(const std::vector<Stop::Fact>& facts, Ticks now) {
  std::vector<std::pair<std::string, bool>> parts;
  for (const Stop::Fact& fact : facts) {
    std::string text = fact.name + " = " + fact.value;
    if (fact.since && *fact.since > Ticks{}) text += " for " + format_seconds(now - *fact.since) + " s";
    parts.emplace_back(std::move(text), fact.fault);
  }
  return parts;
}

std::string_view word_of(Prospect::Kind kind) {
  switch (kind) {
    case Prospect::Kind::command:
      return "command";
    case Prospect::Kind::transition:
      return "transition";
    case Prospect::Kind::stay:
      return "stay";
    case Prospect::Kind::fault:
      return "fault";
  }
  return {};
}

/// `from 30 s on, by 60 s`, `now, by 60 s`: in time since the start.
std::string window_text(const Prospect::Window& window, Ticks now) {
  const std::string from = window.from > now ? "from " + format_seconds(window.from) + " s on" : "now";
  if (window.to.is_infinite()) return from;
  return from + ", by " + format_seconds(window.to) + " s";
}

}  // namespace

std::vector<Stop::Fact> facts_of(const automata::Plant& plant, const automata::Modes& modes,
                                 const std::vector<Ticks>& since) {
  std::vector<Stop::Fact> facts;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    const automata::Component& component = plant.components[c];
    const automata::Mode& mode = component.modes[modes[c].index()];
    Stop::Fact fact{component.name, mode.name, mode.fault, std::nullopt};
    if (c < since.size()) fact.since = since[c];
    facts.push_back(std::move(fact));
  }
  return facts;
}

std::vector<Stop::Fact> facts_of(const automata::Plant& plant, const automata::Observation& readings) {
  std::vector<Stop::Fact> facts;
  for (const automata::Assignment& reading : readings) {
    facts.push_back({plant.variables.name(reading.variable), plant.variables.value(reading), false, std::nullopt});
  }
  return facts;
}

std::string to_text(const Stop& stop, base::Painter painter) {
  std::string text = painter.strong("at " + moment(stop.time)) + ", after " + std::to_string(stop.cycle) +
                     (stop.of_witness ? " event" : " cycle") + (stop.cycle == 1 ? "\n" : "s\n");
  Rows rows(text, painter);
  if (!stop.truth.empty()) rows.add_all("truth", parts_of(stop.truth, stop.time));
  if (!stop.estimate.empty()) {
    const std::string likely = stop.belief.empty() ? "" : three_digits(stop.belief.front().probability) + "  ";
    if (stop.believes_truth) {
      rows.add("belief", likely + painter.quiet("equals the truth"));
    } else {
      auto parts = parts_of(stop.estimate, stop.time);
      if (!likely.empty() && !parts.empty()) parts.front().first = likely + parts.front().first;
      rows.add_all("belief", parts);
    }
    for (std::size_t b = 1; b < stop.belief.size(); ++b) {
      rows.add("", three_digits(stop.belief[b].probability) + "  " + stop.belief[b].text);
    }
  }
  if (!stop.readings.empty()) rows.add_all("readings", parts_of(stop.readings, stop.time));
  for (const std::string& told : stop.told) rows.add("events", painter.bad(told));
  if (stop.ended) rows.add("marking", "none: the program has ended");
  if (stop.over) {
    rows.add("next", "nothing: the run has ended");
    return text;
  }
  rows.add_lines("marking", stop.marking);
  if (stop.goals.empty()) rows.add("goal", "none");
  rows.add_lines("goal", stop.goals);
  rows.add("command",
           (stop.command.empty() ? "none" : stop.command) + (stop.why.empty() ? "" : painter.quiet(" " + stop.why)));
  return text;
}

std::string why_text(const Stop& stop, base::Painter painter) {
  std::string text;
  Rows rows(text, painter);
  rows.add("command", (stop.command.empty() ? "none" : stop.command) +
                          (stop.why.empty() ? ": every goal is achieved" : " " + stop.why));
  for (const std::string& told : stop.told) rows.add("events", told);
  for (const std::string& fault : stop.faults) rows.add("fault", fault);
  return text;
}

bool can_be_chosen(const Prospect& prospect) {
  return prospect.kind == Prospect::Kind::command || prospect.probability > 0;
}

std::string to_text(const Prospect& prospect, const automata::Plant& plant, Ticks now) {
  std::string text = to_text(plant.variables, prospect.what);
  if (prospect.kind == Prospect::Kind::command) {
    const std::size_t control = *automata::control_of(plant, prospect.what.variable);
    if (plant.controls[control].idle == prospect.what.value) text += " (idle)";
    std::string lets;
    for (const std::string& one : prospect.lets) lets += (lets.empty() ? "; lets " : ", ") + one;
    return text + lets;
  }
  if (prospect.kind == Prospect::Kind::stay) text += " still";
  if (prospect.window) text += ", " + window_text(*prospect.window, now);
  if (prospect.probability > 0) {
    text += ", probability " + three_digits(prospect.probability);
  } else if (prospect.window && prospect.window->from <= now) {
    text += ", probability 0 so far";
  }
  return text + in_parentheses(prospect.origin);
}

std::string to_text(const std::vector<Prospect>& prospects, const automata::Plant& plant, Ticks now, Ticks until,
                    base::Painter painter) {
  if (prospects.empty()) return "only time can pass\n";
  std::string text = painter.strong("what may happen until " + moment(until)) + "\n";
  std::size_t number = 0;
  for (const Prospect& prospect : prospects) {
    std::string mark = can_be_chosen(prospect) ? std::to_string(++number) : "-";
    constexpr std::size_t columns = 5;
    mark.insert(0, columns - std::min(columns, mark.size()), ' ');
    const std::string word = padded(std::string(word_of(prospect.kind)), word_width);
    text += mark + "  " + (prospect.kind == Prospect::Kind::fault ? painter.bad(word) : painter.note(word)) + " " +
            to_text(prospect, plant, now) + "\n";
  }
  return text;
}

}  // namespace rmpl::runtime
