// What is told of a line: modes, belief, what most likely happened, what it cost.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/estimate_answer.hpp"

#include "runtime/executive/trace/event.hpp"
#include "runtime/executive/trace/trace_writer.hpp"

namespace rmpl::tools {

using runtime::Event;
using runtime::JsonLine;
using runtime::PlantTrajectory;

namespace {

/// With a table, only the clocks that it has for their component and mode: the others are forgotten.
void write(JsonLine& json, const PlantHistory& history, const automata::Plant& plant,
           const runtime::ClockTable* clocks) {
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

}  // namespace

void write(JsonLine& json, const PlantAnswer& answer, const automata::Plant& plant) {
  const runtime::LogLine& line = answer.line;
  const runtime::Estimate& estimate = answer.estimate;
  json.clear();
  json.open('{');
  if (line.cycle) json.key("cycle").number(*line.cycle);
  json.key("time").seconds(line.time).key("estimate").modes(estimate.modes, plant);
  json.key("belief").belief(answer.belief, plant, line.time, answer.clocks, answer.ranks ? &estimate.rank : nullptr);
  if (answer.history != nullptr) write(json, *answer.history, plant, answer.clocks);
  if (estimate.cut) json.key("cut").boolean(true);
  if (answer.cost != nullptr) {
    json.key("checked").number(answer.cost->checked);
    if (!answer.ranks)
      json.key("dropped").number(answer.cost->dropped).key("missing_mass").number(answer.cost->missing);
  }
  std::vector<Event> events;
  if (!estimate.consistent) {
    events.push_back(
        {Event::Kind::inconsistent, "no state that is tracked explains the observations", std::nullopt, std::nullopt});
  }
  if (estimate.cut) {
    events.push_back(
        {Event::Kind::cut, "the search ended early; the belief may lack states", std::nullopt, std::nullopt});
  }
  if (!events.empty()) {
    json.key("events");
    write_events(json, events, &plant);
  }
  json.close('}');
}

}  // namespace rmpl::tools
