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
#include "runtime/reasoning/estimate/set_aside.hpp"

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

/// What the lines of a log say one after the other.
class Readings {
 public:
  Readings(LogReader reader, std::string name, Consistent consistent)
      : reader_(std::move(reader)), name_(std::move(name)), consistent_(std::move(consistent)) {}

  struct Line {
    LogLine text;
    Reading reading;
  };
  std::optional<Line> next() {
    auto text = reader_.next();
    if (!text) return std::nullopt;
    if (text->estimate) estimate_ = *text->estimate;
    if (!consistent_(estimate_)) {
      throw base::InputError(name_ + ":" + std::to_string(text->number) +
                             ": the estimate contradicts the plant model: no such state is possible");
    }
    Reading reading;
    auto& known = reading.knowledge.assignments;
    known = estimate_;
    const automata::Observation counted = without(text->observations, text->set_aside);
    known.insert(known.end(), counted.begin(), counted.end());
    reading.consistent = consistent_(known);
    if (!reading.consistent) known = estimate_;
    return Line{*std::move(text), std::move(reading)};
  }

 private:
  LogReader reader_;
  std::string name_;
  Consistent consistent_;
  std::vector<Assignment> estimate_;
};

/// What the sequencer takes of what a line tells.
using Understand = std::function<std::optional<Assignment>(Assignment)>;

class LogRun {
 public:
  LogRun(const automata::Program& program, const automata::Variables& variables, automata::ProgramStep step)
      : program_(program), variables_(variables), step_(std::move(step)) {}

  void run(Readings& readings, const Understand& understand, const Answer& answer) {
    const auto read = [&] {
      auto line = readings.next();
      if (!line) return line;
      std::vector<Assignment> understood;
      for (const Assignment& told : line->reading.knowledge.assignments) {
        if (const auto known = understand(told)) understood.push_back(*known);
      }
      line->reading.knowledge.assignments = std::move(understood);
      line->reading.knowledge.answers = answers(line->text);
      return line;
    };
    auto line = read();
    std::uint64_t number = 0;
    for (auto next = line ? read() : std::nullopt; next; next = read()) {
      for (std::uint64_t left_out = 0; !ended_ && left_out <= next->text.unchanged; ++left_out) {
        cycle(++number, left_out == 0 ? line->text.time : next->text.time_of_unchanged(left_out), line->reading);
        answer(line_.text());
        ended_ = step_.ended();
        const bool last = left_out == next->text.unchanged;
        if (!ended_) step_.finish((last ? next : line)->reading.knowledge);
      }
      line = std::move(next);
    }
  }

 private:
  /// What a line says of the atoms that the program asks: white space does not matter, and what a line does not name is
  /// not so. It may name what the program does not ask.
  [[nodiscard]] std::vector<bool> answers(const LogLine& line) const {
    const auto bare = [](std::string text) {
      std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
      return text;
    };
    std::vector<bool> result;
    for (const automata::Formula& atom : step_.asked()) {
      const std::string wanted = bare(to_text(atom, variables_));
      result.push_back(std::any_of(line.known.begin(), line.known.end(),
                                   [&](const std::string& known) { return bare(known) == wanted; }));
    }
    return result;
  }

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
    write_goals(asserted);
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

  /// Without a planner all are pursued; those of branches are told apart.
  void write_goals(const automata::Asserted& asserted) {
    const automata::Goals none;
    const bool acts = asserted.conflicts.empty();
    const automata::Goals& own = acts ? asserted : none;
    line_.key("goal").assignments(own.goal, variables_);
    write_constraints(own);
    if (!acts || asserted.branches.empty()) return;
    line_.key("each").open('[');
    for (const automata::Goals& branch : asserted.branches) {
      line_.open('{').key("goal").assignments(branch.goal, variables_);
      write_constraints(branch);
      line_.close('}');
    }
    line_.close(']');
  }

  void write_constraints(const automata::Goals& goals) {
    if (goals.constraints.empty()) return;
    line_.key("goal_constraints").open('[');
    for (const automata::GoalConstraint& constraint : goals.constraints) {
      line_.open('{').key("constraint").string(to_text(constraint.formula, variables_));
      line_.key("location").number(constraint.by.index() + 1).close('}');
    }
    line_.close(']');
  }

  const automata::Program& program_;
  const automata::Variables& variables_;
  automata::ProgramStep step_;
  JsonLine line_;
  bool ended_ = false;
};

}  // namespace

void sequence_log(const automata::Program& program, const automata::Plant& plant, std::istream& log,
                  const std::string& name, const Answer& answer) {
  automata::Theory theory = automata::model_theory(plant);
  Readings readings({log, name, plant}, name, [&theory](const auto& known) { return theory.consistent(known); });
  LogRun(program, plant.variables, automata::ProgramStep(program, plant))
      .run(
          readings, [](Assignment told) { return told; }, answer);
}

void sequence_log(const automata::Program& program, std::istream& log, const std::string& name, const Answer& answer) {
  // The value that no text can name keeps every domain open: not to be known as v is not to be known as something else.
  automata::Program open = program;
  for (std::size_t v = 0; v < open.variables.size(); ++v) {
    open.variables.add_value(automata::VariableId(v), "(any other)");
  }
  automata::Variables names = program.variables;
  // Without a model, knowledge contradicts itself only where estimate and observations give a variable two values.
  const auto consistent = [](const std::vector<Assignment>& known) {
    std::vector<Assignment> sorted = known;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end(), [](const Assignment& a, const Assignment& b) {
             return a.variable == b.variable;
           }) == sorted.end();
  };
  // The program asks of its own variables alone, and of a value that it has no word for only whether it is another.
  const auto understand = [&program](Assignment told) -> std::optional<Assignment> {
    if (told.variable.index() >= program.variables.size()) return std::nullopt;
    const std::size_t other = program.variables[told.variable].values.size();
    return Assignment{told.variable, automata::ValueId(std::min(told.value.index(), other))};
  };
  Readings readings({log, name, names}, name, consistent);
  LogRun(open, open.variables, automata::ProgramStep(open)).run(readings, understand, answer);
}

namespace {

Answer collect(std::string& text) {
  return [&text](std::string_view line) { (text += line) += '\n'; };
}

}  // namespace

std::string sequence_log(const automata::Program& program, const automata::Plant& plant, std::istream& log,
                         const std::string& name) {
  std::string text;
  sequence_log(program, plant, log, name, collect(text));
  return text;
}

std::string sequence_log(const automata::Program& program, std::istream& log, const std::string& name) {
  std::string text;
  sequence_log(program, log, name, collect(text));
  return text;
}

}  // namespace rmpl::runtime
