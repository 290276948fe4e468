// Cycles of the sequencer from lines of a log.
// SPDX-License-Identifier: MIT
#include "runtime/executive/sequence/log_run.hpp"

#include <algorithm>
#include <functional>

#include "automata/logic/theory.hpp"
#include "automata/step/program_step.hpp"
#include "automata/store/model.hpp"
#include "base/error.hpp"
#include "runtime/executive/sequence/goal_conflict.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/executive/trace/trace_writer.hpp"

namespace rmpl::runtime {
namespace {

using automata::Assignment;

/// What the sequencer knows at the start of one cycle.
struct Reading {
  automata::Knowledge knowledge;
  bool consistent = true;
};

/// Whether the estimate can hold; asked again with the observations.
using Consistent = std::function<bool(const std::vector<Assignment>&)>;

std::vector<Reading> readings_of(const std::vector<LogLine>& lines, const std::string& name,
                                 const Consistent& consistent) {
  std::vector<Reading> readings;
  const std::vector<Assignment> nothing;
  const std::vector<Assignment>* estimate = &nothing;
  for (const LogLine& line : lines) {
    if (line.estimate) estimate = &*line.estimate;
    if (!consistent(*estimate)) {
      throw base::InputError(name + ":" + std::to_string(line.number) +
                             ": the estimate contradicts the plant model: no such state is possible");
    }
    Reading& reading = readings.emplace_back();
    reading.knowledge.assignments = *estimate;
    reading.knowledge.assignments.insert(reading.knowledge.assignments.end(), line.observations.begin(),
                                         line.observations.end());
    reading.consistent = consistent(reading.knowledge.assignments);
    if (!reading.consistent) reading.knowledge.assignments = *estimate;
  }
  return readings;
}

class LogRun {
 public:
  LogRun(const automata::Program& program, const automata::Variables& variables, automata::ProgramStep step)
      : program_(program), variables_(variables), step_(std::move(step)) {}

  std::string run(const std::vector<LogLine>& lines, const std::vector<Reading>& readings) {
    std::string text;
    std::uint64_t number = 0;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      const LogLine& next = lines[i + 1];
      for (std::uint64_t left_out = 0; left_out <= next.unchanged; ++left_out) {
        cycle(++number, left_out == 0 ? lines[i].time : next.time_of_unchanged(left_out), readings[i]);
        text += line_.text() + "\n";
        if (step_.ended()) return text;
        step_.finish(readings[left_out == next.unchanged ? i + 1 : i].knowledge);
      }
    }
    return text;
  }

 private:
  /// The first half of a cycle, and its line.
  void cycle(std::uint64_t number, automata::Ticks now, const Reading& reading) {
    line_.clear();
    line_.open('{').key("cycle").number(number).key("time").seconds(now).key("marking").open('[');
    for (const automata::LocationId location : step_.marking()) line_.number(location.index() + 1);
    line_.close(']');
    const automata::Asserted& asserted = step_.begin(reading.knowledge, now);
    std::vector<Event> events;
    if (!reading.consistent) {
      events.push_back(
          {Event::Kind::inconsistent, "the observations contradict the estimate", std::nullopt, std::nullopt});
    }
    for (const automata::GoalConflict& conflict : asserted.conflicts) {
      events.push_back(describe(conflict, program_, variables_));
    }
    const std::vector<Assignment> none;
    line_.key("goal").assignments(asserted.conflicts.empty() ? asserted.goal : none, variables_);
    line_.key("clocks").open('{');
    for (std::size_t c = 0; c < program_.clocks.size(); ++c) {
      if (const auto& reading_of_clock = step_.clocks()[c]) line_.key(program_.clocks[c]).seconds(*reading_of_clock);
    }
    line_.close('}');
    if (!events.empty()) {
      line_.key("events");
      write_events(line_, events, nullptr);
    }
    line_.close('}');
  }

  const automata::Program& program_;
  const automata::Variables& variables_;
  automata::ProgramStep step_;
  JsonLine line_;
};

}  // namespace

std::string sequence_log(const automata::Program& program, const automata::Plant& plant, std::istream& log,
                         const std::string& name) {
  const std::vector<LogLine> lines = read_log(log, name, plant);
  automata::Theory theory = automata::model_theory(plant);
  const auto readings = readings_of(lines, name, [&](const auto& known) { return theory.consistent(known); });
  return LogRun(program, plant.variables, automata::ProgramStep(program, plant)).run(lines, readings);
}

std::string sequence_log(const automata::Program& program, std::istream& log, const std::string& name) {
  automata::Program open = program;
  const std::vector<LogLine> lines = read_log(log, name, open.variables);
  // The value that no text can name keeps every domain open: not to be known as v is not to be known as something else.
  for (std::size_t v = 0; v < open.variables.size(); ++v) {
    open.variables.add_value(automata::VariableId(v), "(any other)");
  }
  // Without a model, knowledge contradicts itself only where estimate and observations give a variable two values.
  const auto consistent = [](const std::vector<Assignment>& known) {
    std::vector<Assignment> sorted = known;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end(), [](const Assignment& a, const Assignment& b) {
             return a.variable == b.variable;
           }) == sorted.end();
  };
  const auto readings = readings_of(lines, name, consistent);
  return LogRun(open, open.variables, automata::ProgramStep(open)).run(lines, readings);
}

}  // namespace rmpl::runtime
