// The keys of a trace line, in the order of the contract.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/trace_writer.hpp"

#include <utility>

#include "runtime/executive/trace/evidence_line.hpp"
#include "runtime/executive/trace/place.hpp"
#include "runtime/executive/trace/reasons.hpp"

namespace rmpl::runtime {
TraceWriter::Told::Told(const CycleRecord& record)
    : marking(record.marking),
      goal(record.goal),
      asserted_by(record.asserted_by),
      command(record.command),
      outcome(record.outcome),
      why(record.why),
      observations(record.observations),
      estimate(record.estimate),
      events(record.events) {
  if (record.truth != nullptr) truth = *record.truth;
}

bool TraceWriter::Told::still_true_of(const CycleRecord& record) const {
  return observations == record.observations && estimate == record.estimate && command == record.command &&
         goal == record.goal && asserted_by == record.asserted_by && marking == record.marking &&
         outcome == record.outcome && why == record.why && events == record.events &&
         (record.truth == nullptr || truth == *record.truth);
}

TraceWriter::TraceWriter(const automata::Plant& plant, const automata::Program& program, std::string path,
                         TraceDetail detail)
    : plant_(plant), program_(program), detail_(detail), file_(std::move(path)), live_clocks_(live_clocks(plant)) {}

void TraceWriter::observe(const CycleRecord& record) {
  last_cycle_ = record.cycle;
  last_time_ = record.time;
  if (detail_ == TraceDetail::changes && told_ && told_->still_true_of(record)) {
    ++unchanged_;
    return;
  }
  told_.emplace(record);
  if (detail_ == TraceDetail::beliefs) {
    const Belief belief = record.estimator->belief();
    write(record.cycle, record.time, *told_, record.evidence, &belief);
  } else {
    write(record.cycle, record.time, *told_, record.evidence, nullptr);
  }
  unchanged_ = 0;
}

void TraceWriter::write(std::uint64_t cycle, automata::Ticks time, const Told& told,
                        const std::vector<Evidence>& evidence, const Belief* belief) {
  line_.clear();
  line_.open('{').key("cycle").number(cycle).key("time").seconds(time);
  if (unchanged_ > 0) line_.key("unchanged").number(unchanged_);
  line_.key("marking").open('[');
  for (const automata::LocationId location : told.marking) line_.number(location.index() + 1);
  line_.close(']');
  write_goal(told);
  line_.key("command").open('{');
  for (std::size_t i = 0; i < told.command.size(); ++i) {
    const automata::Control& control = plant_.controls[i];
    if (told.command[i] == control.idle) continue;
    line_.key(plant_.variables.name(control.variable));
    line_.string(plant_.variables.value({control.variable, told.command[i]}));
  }
  line_.close('}');
  write_reason(line_, told.outcome, told.why, told.goal, plant_);
  line_.key("observations").assignments(told.observations, plant_.variables);
  line_.key("estimate").modes(told.estimate, plant_);
  write_evidence(line_, evidence, told.estimate, plant_);
  if (belief != nullptr) line_.key("belief").belief(*belief, plant_, time, &live_clocks_);
  if (told.truth) line_.key("truth").modes(*told.truth, plant_);
  line_.key("events");
  write_events(line_, told.events, &plant_);
  line_.close('}');
  file_.write(line_.text());
  file_.write("\n");
}

void TraceWriter::write_goal(const Told& told) {
  line_.key("goal").assignments(told.goal, plant_.variables);
  if (told.goal.empty()) return;
  line_.key("asserted_by").open('{');
  for (std::size_t i = 0; i < told.goal.size(); ++i) {
    const automata::LocationId location = told.asserted_by[i];
    line_.key(plant_.variables.name(told.goal[i].variable)).open('{').key("location").number(location.index() + 1);
    write_place(line_, program_.locations[location.index()].origin);
    line_.close('}');
  }
  line_.close('}');
}

void TraceWriter::keep() {
  if (unchanged_ > 0) {
    --unchanged_;  // the last cycle is told, so that a reader knows how long the run was
    write(last_cycle_, last_time_, *told_, {}, nullptr);
  }
  file_.keep();
}

void write_events(JsonLine& line, const std::vector<Event>& events, const automata::Plant* plant) {
  line.open('[');
  for (const Event& event : events) {
    line.open('{').key("kind").string(name_of(event.kind));
    if (event.component && plant != nullptr) line.key("component").string((*plant)[*event.component].name);
    if (event.locations) {
      line.key("locations").open('[');
      line.number(event.locations->first.index() + 1).number(event.locations->second.index() + 1).close(']');
    }
    if (!event.message.empty()) line.key("message").string(event.message);
    line.close('}');
  }
  line.close(']');
}

}  // namespace rmpl::runtime
