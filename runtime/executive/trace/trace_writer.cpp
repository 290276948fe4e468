// The keys of a trace line, in the order of the contract.
// SPDX-License-Identifier: MIT
#include "runtime/executive/trace/trace_writer.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "runtime/executive/trace/evidence_line.hpp"
#include "runtime/executive/trace/place.hpp"
#include "runtime/executive/trace/reasons.hpp"

namespace rmpl::runtime {
TraceWriter::Told::Told(const CycleRecord& record)
    : marking(record.marking),
      goals(record.goals),
      left_out(record.left_out),
      known(record.known),
      command(record.command),
      outcome(record.outcome),
      why(record.why),
      observations(record.observations),
      set_aside(record.set_aside),
      estimate(record.estimate),
      events(record.events) {
  if (record.truth != nullptr) truth = *record.truth;
}

bool TraceWriter::Told::still_true_of(const CycleRecord& record) const {
  return observations == record.observations && set_aside == record.set_aside && estimate == record.estimate &&
         command == record.command && goals == record.goals && left_out == record.left_out && known == record.known &&
         marking == record.marking && outcome == record.outcome && why == record.why && events == record.events &&
         (record.truth == nullptr || truth == *record.truth);
}

TraceWriter::TraceWriter(const automata::Plant& plant, const automata::Program& program, std::string path,
                         TraceDetail detail, std::uint64_t keyframe)
    : plant_(plant),
      program_(program),
      detail_(detail),
      file_(std::in_place, std::move(path)),
      sink_([this](std::string_view line) { file_->write(line); }),
      live_clocks_(live_clocks(plant)),
      keyframe_(keyframe) {}

TraceWriter::TraceWriter(const automata::Plant& plant, const automata::Program& program, Sink sink, TraceDetail detail,
                         std::uint64_t keyframe)
    : plant_(plant),
      program_(program),
      detail_(detail),
      sink_(std::move(sink)),
      live_clocks_(live_clocks(plant)),
      keyframe_(keyframe) {}

/// The last sample of each channel since the line before is for the next one.
void TraceWriter::hear(const CycleRecord& record) {
  for (const Sample& sample : record.samples) {
    std::erase_if(heard_, [&](const Sample& before) { return before.channel == sample.channel; });
    heard_.push_back(sample);
  }
  if (!record.samples.empty() && channels_.size() != record.channels->size()) channels_ = *record.channels;
}

void TraceWriter::observe(const CycleRecord& record) {
  last_cycle_ = record.cycle;
  last_time_ = record.time;
  hear(record);
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
  const bool delta = detail_ == TraceDetail::changes && written_ && since_keyframe_ < keyframe_;
  since_keyframe_ = delta ? since_keyframe_ + 1 : 1;
  line_.clear();
  line_.open('{').key("cycle").number(cycle).key("time").seconds(time);
  if (delta) {
    line_.key("delta").boolean(true);
    write_changes(told, *written_, evidence);
  } else {
    if (unchanged_ > 0) line_.key("unchanged").number(unchanged_);
    write_all(told, time, evidence, belief);
  }
  line_.close('}');
  sink_(line_.text() + "\n");
  if (detail_ == TraceDetail::changes) written_.emplace(told);
}

namespace {

void write_marking(JsonLine& line, const automata::Marking& marking) {
  line.key("marking").open('[');
  for (const automata::LocationId location : marking) line.number(location.index() + 1);
  line.close(']');
}

/// Assignments that changed; of variables that have no value any more, null. Both are sorted by variable.
void write_changed(JsonLine& line, std::string_view key, const std::vector<automata::Assignment>& now,
                   const std::vector<automata::Assignment>& before, const automata::Variables& variables) {
  if (now == before) return;
  line.key(key).open('{');
  const auto is_of = [](automata::VariableId variable) {
    return [variable](const automata::Assignment& other) { return other.variable == variable; };
  };
  for (const automata::Assignment& a : now) {
    const auto known = std::find_if(before.begin(), before.end(), is_of(a.variable));
    if (known == before.end() || known->value != a.value)
      line.key(variables.name(a.variable)).string(variables.value(a));
  }
  for (const automata::Assignment& a : before) {
    if (std::none_of(now.begin(), now.end(), is_of(a.variable))) line.key(variables.name(a.variable)).null();
  }
  line.close('}');
}

void write_changed(JsonLine& line, std::string_view key, const automata::Modes& now, const automata::Modes& before,
                   const automata::Plant& plant) {
  if (now == before) return;
  line.key(key).open('{');
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    if (now[c] == before[c]) continue;
    const automata::Component& component = plant.components[c];
    line.key(component.name).string(component.modes[now[c].index()].name);
  }
  line.close('}');
}

}  // namespace

void TraceWriter::write_changes(const Told& told, const Told& before, const std::vector<Evidence>& evidence) {
  if (told.marking != before.marking) write_marking(line_, told.marking);
  write_goal_changes(told, before);
  if (told.command != before.command) {
    line_.key("command").open('{');
    for (std::size_t i = 0; i < told.command.size(); ++i) {
      if (told.command[i] == before.command[i]) continue;
      const automata::Control& control = plant_.controls[i];
      line_.key(plant_.variables.name(control.variable));
      if (told.command[i] == control.idle) {
        line_.null();
      } else {
        line_.string(plant_.variables.value({control.variable, told.command[i]}));
      }
    }
    line_.close('}');
  }
  if (told.outcome != before.outcome || !(told.why == before.why) || told.goals != before.goals) {
    if (told.outcome == Reconfiguration::Outcome::nothing_to_do) {
      if (before.outcome != told.outcome) line_.key("reason").null();
    } else {
      write_reason(line_, told.outcome, told.why, told.goals, plant_);
    }
  }
  write_samples();
  write_changed(line_, "observations", told.observations, before.observations, plant_.variables);
  write_changed(line_, "set_aside", told.set_aside, before.set_aside, plant_.variables);
  write_changed(line_, "estimate", told.estimate, before.estimate, plant_);
  if (told.known != before.known) write_known(told);
  write_evidence(line_, evidence, told.estimate, plant_);
  if (told.truth && before.truth) write_changed(line_, "truth", *told.truth, *before.truth, plant_);
  if (told.events != before.events) {
    line_.key("events");
    write_events(line_, told.events, &plant_);
  }
}

void TraceWriter::write_all(const Told& told, automata::Ticks time, const std::vector<Evidence>& evidence,
                            const Belief* belief) {
  write_marking(line_, told.marking);
  write_goal(told);
  line_.key("command").open('{');
  for (std::size_t i = 0; i < told.command.size(); ++i) {
    const automata::Control& control = plant_.controls[i];
    if (told.command[i] == control.idle) continue;
    line_.key(plant_.variables.name(control.variable));
    line_.string(plant_.variables.value({control.variable, told.command[i]}));
  }
  line_.close('}');
  write_reason(line_, told.outcome, told.why, told.goals, plant_);
  write_samples();
  line_.key("observations").assignments(told.observations, plant_.variables);
  if (!told.set_aside.empty()) line_.key("set_aside").assignments(told.set_aside, plant_.variables);
  line_.key("estimate").modes(told.estimate, plant_);
  if (!told.known.empty()) write_known(told);
  write_evidence(line_, evidence, told.estimate, plant_);
  if (belief != nullptr) line_.key("belief").belief(*belief, plant_, time, &live_clocks_);
  if (told.truth) line_.key("truth").modes(*told.truth, plant_);
  line_.key("events");
  write_events(line_, told.events, &plant_);
}

void TraceWriter::write_samples() {
  if (heard_.empty()) return;
  line_.key("channels");
  write_channels(line_, heard_, channels_);
  heard_.clear();
}

void TraceWriter::write_asserting(automata::LocationId location) {
  line_.key("location").number(location.index() + 1);
  write_place(line_, program_.locations[location.index()].origin);
}

void TraceWriter::write_by(automata::Assignment goal, automata::LocationId location) {
  line_.key(plant_.variables.name(goal.variable)).open('{');
  write_asserting(location);
  line_.close('}');
}

void TraceWriter::write_goal(const Told& told) {
  const automata::Goals& goals = told.goals;
  line_.key("goal").assignments(goals.goal, plant_.variables);
  if (!goals.goal.empty()) {
    line_.key("asserted_by").open('{');
    for (std::size_t i = 0; i < goals.goal.size(); ++i) write_by(goals.goal[i], goals.by[i]);
    line_.close('}');
  }
  if (!goals.constraints.empty()) write_constraints(told);
  if (!told.left_out.empty()) write_left_out(told);
}

/// What is empty now is told as empty.
void TraceWriter::write_goal_changes(const Told& told, const Told& before) {
  const automata::Goals& goals = told.goals;
  write_changed(line_, "goal", goals.goal, before.goals.goal, plant_.variables);
  if (goals.goal != before.goals.goal || goals.by != before.goals.by) {
    line_.key("asserted_by").open('{');
    for (std::size_t i = 0; i < goals.goal.size(); ++i) write_by(goals.goal[i], goals.by[i]);
    for (const automata::Assignment& goal : before.goals.goal) {
      const auto same = [&](const automata::Assignment& now) { return now.variable == goal.variable; };
      if (std::none_of(goals.goal.begin(), goals.goal.end(), same))
        line_.key(plant_.variables.name(goal.variable)).null();
    }
    line_.close('}');
  }
  if (goals.constraints != before.goals.constraints) write_constraints(told);
  if (told.left_out != before.left_out) write_left_out(told);
}

void TraceWriter::write_constraints(const Told& told) {
  line_.key("goal_constraints").open('[');
  for (const automata::GoalConstraint& constraint : told.goals.constraints) {
    line_.open('{').key("constraint").string(to_text(constraint.formula, plant_.variables));
    write_asserting(constraint.by);
    line_.close('}');
  }
  line_.close(']');
}

void TraceWriter::write_left_out(const Told& told) {
  line_.key("left_out").open('[');
  for (const LeftOut& left_out : told.left_out) {
    line_.open('{').key("goal").string(to_text(left_out.goals.formula(), plant_.variables));
    write_asserting(left_out.goals.goal.empty() ? left_out.goals.constraints.front().by : left_out.goals.by.front());
    line_.key("message").string(left_out.reason).close('}');
  }
  line_.close(']');
}

void TraceWriter::write_known(const Told& told) {
  line_.key("known").open('[');
  for (const std::string& atom : told.known) line_.string(atom);
  line_.close(']');
}

void TraceWriter::keep() {
  if (unchanged_ > 0) {
    --unchanged_;  // the last cycle is told, so that a reader knows how long the run was
    write(last_cycle_, last_time_, *told_, {}, nullptr);
  }
  if (file_) file_->keep();
}

void write_channels(JsonLine& line, const std::vector<Sample>& samples, const std::vector<std::string>& channels) {
  line.open('{');
  for (auto sample = samples.begin(); sample != samples.end(); ++sample) {
    const auto is_same = [&](const Sample& later) { return later.channel == sample->channel; };
    if (std::any_of(sample + 1, samples.end(), is_same)) continue;  // a key stands once; the last counts
    line.key(channels[sample->channel]);
    if (sample->number && std::isfinite(*sample->number)) {
      line.number(*sample->number);
    } else {
      line.string(sample->text);
    }
  }
  line.close('}');
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
