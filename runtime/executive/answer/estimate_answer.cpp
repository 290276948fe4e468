// What is told of a line: modes, belief, what most likely happened, what it cost.
// SPDX-License-Identifier: MIT
#include "runtime/executive/answer/estimate_answer.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>

#include "automata/assignment_text.hpp"
#include "runtime/executive/trace/event.hpp"
#include "runtime/executive/trace/surprise.hpp"
#include "runtime/executive/trace/trace_writer.hpp"
#include "runtime/reasoning/estimate/rank.hpp"

namespace rmpl::runtime {

namespace {

/// With a table, only the clocks that it has for their component and mode: the others are forgotten.
void write(JsonLine& json, const PlantHistory& history, const automata::Plant& plant, const ClockTable* clocks) {
  json.key("history").open('[');
  for (const PlantTrajectory& trajectory : history.trajectories) {
    json.open('{').key("probability").number(trajectory.probability).key("trajectory").open('[');
    for (std::size_t t = 0; t < trajectory.states.size(); ++t) {
      const automata::SystemState& state = trajectory.states[t];
      json.open('{').key("time").seconds(history.times[t]).key("modes").modes(state.modes, plant);
      json.key("clocks").open('{');
      for (std::size_t c = 0; c < plant.components.size(); ++c) {
        if (clocks != nullptr && !(*clocks)[c][state.modes[c].index()]) continue;
        json.key(plant.components[c].name).seconds(history.times[t] - state.clock_starts[c]);
      }
      json.close('}').close('}');
    }
    json.close(']').close('}');
  }
  json.close(']').key("revised").open('[');
  for (const PlantHistory::Revision& revision : history.revised) {
    json.open('{').key("time").seconds(revision.time).key("before").modes(revision.before, plant);
    json.key("modes").modes(revision.now, plant).close('}');
  }
  json.close(']');
  if (history.cut) json.key("history_cut").boolean(true);
}

/// All but when it was, and what was sampled.
void write_rest(JsonLine& json, const PlantAnswer& answer, const automata::Plant& plant,
                base::FunctionRef<void()> go_on) {
  const LogLine& line = answer.line;
  const Estimate& estimate = answer.estimate;
  if (answer.channels != nullptr) json.key("observations").assignments(line.observations, plant.variables);
  json.key("estimate").modes(estimate.modes, plant);
  json.key("belief").belief(answer.belief, plant, line.time, answer.clocks, answer.ranks ? &estimate.rank : nullptr,
                            go_on);
  if (!estimate.set_aside.empty()) json.key("set_aside").assignments(estimate.set_aside, plant.variables);
  if (answer.history != nullptr) write(json, *answer.history, plant, answer.clocks);
  if (estimate.cut) json.key("cut").boolean(true);
  if (answer.missing) json.key("missing_mass").number(*answer.missing);
  if (answer.cost != nullptr) {
    json.key("checked").number(answer.cost->checked);
    if (!answer.ranks) json.key("dropped").number(answer.cost->dropped);
  }
  std::vector<Event> events;
  if (auto surprise = surprise_of(estimate, plant.variables)) events.push_back(*std::move(surprise));
  if (estimate.cut) {
    events.push_back(
        {Event::Kind::cut, "the search ended early; the belief may lack states", std::nullopt, std::nullopt});
  }
  if (answer.history != nullptr && !answer.history->unexplained.empty()) {
    events.push_back(
        {Event::Kind::inconsistent, to_text(answer.history->unexplained, plant.variables), std::nullopt, std::nullopt});
  }
  if (!events.empty()) {
    json.key("events");
    write_events(json, events, &plant);
  }
}

}  // namespace

std::string as_text(const PlantAnswer& answer, const automata::Plant& plant) {
  std::ostringstream text;
  text << "at " << automata::format_seconds(answer.line.time) << " s\n";
  if (answer.channels != nullptr && !answer.line.samples.empty()) {
    text << "  sampled   ";
    const char* separator = "";
    for (const Sample& sample : answer.line.samples) {
      text << std::exchange(separator, ", ") << (*answer.channels)[sample.channel] << " = " << sample.text;
    }
    text << '\n';
  }
  const std::string read = to_text(plant.variables, answer.line.observations);
  text << "  read      " << (read.empty() ? "nothing" : read) << '\n';
  if (const auto& aside = answer.estimate.set_aside; !aside.empty()) {
    text << "  set aside " << to_text(plant.variables, aside) << ": nothing explains it\n";
  }
  for (const BeliefEntry& entry : answer.belief) {
    text << "  " << std::setw(8) << std::left << std::setprecision(4);
    if (answer.ranks) {
      text << "rank " + std::to_string(answer.estimate.rank + rank_of(entry.probability));
    } else {
      text << entry.probability;
    }
    const char* separator = "  ";
    for (std::size_t c = 0; c < plant.components.size(); ++c) {
      const automata::Component& component = plant.components[c];
      text << std::exchange(separator, ", ") << component.name << " = "
           << component.modes[entry.state.modes[c].index()].name;
    }
    text << '\n';
  }
  if (answer.estimate.cut) text << "  the search ended early; the belief may lack states\n";
  return text.str();
}

std::string missing_text(double share) {
  std::ostringstream text;
  text << "up to " << std::setprecision(3) << 100 * share
       << " % of the probability may be missing from a belief; increase -k, or use --estimator exact";
  return text.str();
}

std::string to_text(const std::vector<UnexplainedByHistory>& unexplained, const automata::Variables& variables) {
  std::string text;
  for (const UnexplainedByHistory& update : unexplained) {
    text += (text.empty() ? "" : ", ") + to_text(variables, update.readings) + " at " +
            automata::format_seconds(update.time) + " s";
  }
  return "no history explains " + text + ": set aside";
}

void AnswerWriter::write(JsonLine& json, const PlantAnswer& answer, const automata::Plant& plant,
                         base::FunctionRef<void()> go_on) {
  json.clear();
  json.open('{');
  if (answer.line.cycle) json.key("cycle").number(*answer.line.cycle);
  json.key("time").seconds(answer.line.time);
  if (answer.channels != nullptr) write_channels(json.key("channels"), answer.line.samples, *answer.channels);
  const std::size_t begin = json.text().size();
  if (answer.repeats) return void(json.raw(rest_));
  write_rest(json, answer, plant, go_on);
  json.close('}');
  rest_.assign(json.text(), begin);
}

}  // namespace rmpl::runtime
