// What is told of a line: markings, belief, what most likely happened.
// SPDX-License-Identifier: MIT
#include "runtime/executive/answer/marking_answer.hpp"

#include <algorithm>
#include <sstream>

#include "automata/assignment_text.hpp"
#include "automata/place.hpp"
#include "runtime/executive/trace/event.hpp"
#include "runtime/executive/trace/trace_writer.hpp"

namespace rmpl::runtime {

using automata::Marking;
using automata::ModelProgram;
using automata::Ticks;

namespace {

std::string what_went_wrong(const MarkingEstimate& estimate, const automata::Variables& variables) {
  std::string text;
  if (!estimate.set_aside.empty()) {
    text = "no tracked marking explains " + to_text(variables, estimate.set_aside) + ": set aside";
  }
  if (estimate.possible) return text;
  return text + (text.empty() ? "" : "; ") + "no tracked marking has a possible step: the belief stays";
}

void put_marking(JsonLine& json, const Marking& marking) {
  json.open('[');
  for (const automata::LocationId l : marking) json.number(l.value + 1);
  json.close(']');
}

std::string seconds_text(Ticks time) { return automata::format_seconds(time) + " s"; }

/// Where a location stands; the file only where there are several.
std::string place_of(const automata::Origin& origin, const ModelProgram& program) {
  const bool one_file = std::all_of(program.locations.begin(), program.locations.end(),
                                    [&](const auto& location) { return location.origin.file == origin.file; });
  if (!one_file) return automata::in_brackets(origin);
  return origin.line == 0 ? "" : " (" + std::to_string(origin.line) + ":" + std::to_string(origin.column) + ")";
}

/// The marked locations with their source; composites, which hold others, are left out.
std::string in_words(const Marking& marking, const ModelProgram& program) {
  if (marking.empty()) return "nothing is marked: the program has ended";
  std::string text;
  for (const automata::LocationId l : marking) {
    const automata::ModelLocation& location = program.locations[l.index()];
    if (location.composite) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(l.value + 1) + " " + location.label +
            place_of(location.origin, program);
  }
  return text;
}

}  // namespace

void write(JsonLine& json, const MarkingAnswer& answer, const ModelProgram& program, bool stats) {
  json.clear();
  json.open('{');
  if (answer.cycle) json.key("cycle").number(*answer.cycle);
  json.key("time").seconds(answer.time);
  if (!answer.belief.empty()) {
    put_marking(json.key("marking"), answer.belief.front().marking);
    json.key("estimate").assignments(answer.belief.front().values, program.variables);
  }
  json.key("belief").open('[');
  for (const MarkingEntry& entry : answer.belief) {
    json.open('{').key("probability").number(entry.probability);
    put_marking(json.key("marking"), entry.marking);
    json.key("values").assignments(entry.values, program.variables).close('}');
  }
  json.close(']');
  if (!answer.estimate.set_aside.empty()) {
    json.key("set_aside").assignments(answer.estimate.set_aside, program.variables);
  }
  if (!answer.times.empty()) {
    json.key("history").open('[');
    for (const MarkingTrajectory& trajectory : answer.history) {
      json.open('{').key("probability").number(trajectory.probability).key("trajectory").open('[');
      for (std::size_t t = 0; t < trajectory.markings.size(); ++t) {
        json.open('{').key("time").seconds(answer.times[t]);
        put_marking(json.key("marking"), trajectory.markings[t]);
        json.close('}');
      }
      json.close(']').close('}');
    }
    json.close(']').key("revised").open('[');
    for (const MarkingAnswer::Revision& revision : answer.revised) {
      json.open('{').key("time").seconds(revision.time);
      put_marking(json.key("before"), revision.before);
      put_marking(json.key("marking"), revision.now);
      json.close('}');
    }
    json.close(']');
  }
  if (answer.estimate.cut) json.key("cut").boolean(true);
  json.key("missing_mass").number(answer.missing);
  if (stats) json.key("checked").number(answer.estimate.checked).key("dropped").number(answer.estimate.missing_mass);
  std::vector<Event> events;
  if (!answer.estimate.explained) {
    events.push_back(
        {Event::Kind::inconsistent, what_went_wrong(answer.estimate, program.variables), std::nullopt, std::nullopt});
  }
  if (answer.estimate.cut) {
    events.push_back(
        {Event::Kind::cut, "the search ended early; the belief may lack markings", std::nullopt, std::nullopt});
  }
  if (!answer.unexplained.empty()) {
    events.push_back(
        {Event::Kind::inconsistent, to_text(answer.unexplained, program.variables), std::nullopt, std::nullopt});
  }
  if (!events.empty()) {
    json.key("events");
    write_events(json, events, nullptr);
  }
  json.close('}');
}

std::string as_text(const MarkingAnswer& answer, const ModelProgram& program) {
  std::ostringstream text;
  text << "at " << seconds_text(answer.time) << '\n';
  if (!answer.estimate.explained) text << "  " << what_went_wrong(answer.estimate, program.variables) << '\n';
  if (answer.estimate.cut) text << "  the search ended early; the belief may lack markings\n";
  for (const MarkingEntry& entry : answer.belief) {
    text << "  " << entry.probability << "  " << in_words(entry.marking, program) << '\n';
    const std::string values = to_text(program.variables, entry.values);
    if (!values.empty()) text << "      " << values << '\n';
  }
  if (!answer.unexplained.empty()) text << "  " << to_text(answer.unexplained, program.variables) << '\n';
  for (const MarkingTrajectory& trajectory : answer.history) {
    text << "  " << trajectory.probability << "  what happened:\n";
    for (std::size_t t = 0; t < trajectory.markings.size(); ++t) {
      text << "      at " << seconds_text(answer.times[t]) << "  " << in_words(trajectory.markings[t], program) << '\n';
    }
  }
  for (const MarkingAnswer::Revision& revision : answer.revised) {
    text << "  revised: at " << seconds_text(revision.time) << "  " << in_words(revision.now, program)
         << "\n      instead of " << in_words(revision.before, program) << '\n';
  }
  return text.str();
}

}  // namespace rmpl::runtime
