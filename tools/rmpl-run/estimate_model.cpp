// One answer a line of the log: as JSON, or for people.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/estimate_model.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <sstream>
#include <vector>

#include "automata/assignment_text.hpp"
#include "base/limit_error.hpp"
#include "runtime/executive/cycle/stopwatch.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/executive/trace/trace_writer.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "tools/rmpl-run/answer_log.hpp"
#include "tools/rmpl-run/latency.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

using automata::Marking;
using automata::ModelProgram;
using automata::Ticks;
using runtime::Event;
using runtime::JsonLine;
using runtime::LogLine;
using runtime::MarkingEntry;
using runtime::MarkingTrajectory;

/// A marking that the most likely trajectory now has at a time, in place of what it had after the line before.
struct Revision {
  Ticks time;
  Marking before, now;
};

/// What is told of a line.
struct Answer {
  std::optional<std::uint64_t> cycle;
  Ticks time;
  runtime::MarkingBelief belief;
  std::vector<Ticks> times;  ///< of the markings of a trajectory
  std::vector<MarkingTrajectory> history;
  std::vector<Revision> revised;
  runtime::MarkingEstimate estimate;
};

const char* what_went_wrong(const runtime::MarkingEstimate& estimate) {
  if (!estimate.possible) return "no step is possible from any marking that is tracked; the belief is the last one";
  return "no marking that is tracked explains the observations; the belief is carried forward without them";
}

void put_marking(JsonLine& json, const Marking& marking) {
  json.open('[');
  for (const automata::LocationId l : marking) json.number(l.value + 1);
  json.close(']');
}

std::string as_json(const Answer& answer, const ModelProgram& program, bool stats) {
  JsonLine json;
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
    for (const Revision& revision : answer.revised) {
      json.open('{').key("time").seconds(revision.time);
      put_marking(json.key("before"), revision.before);
      put_marking(json.key("marking"), revision.now);
      json.close('}');
    }
    json.close(']');
  }
  if (answer.estimate.cut) json.key("cut").boolean(true);
  if (stats) json.key("checked").number(answer.estimate.checked);
  std::vector<Event> events;
  if (!answer.estimate.explained) {
    events.push_back({Event::Kind::inconsistent, what_went_wrong(answer.estimate), std::nullopt, std::nullopt});
  }
  if (answer.estimate.cut) {
    events.push_back(
        {Event::Kind::cut, "the search ended early; the belief may lack markings", std::nullopt, std::nullopt});
  }
  if (!events.empty()) {
    json.key("events");
    write_events(json, events, nullptr);
  }
  json.close('}');
  return json.text() + "\n";
}

std::string seconds_text(Ticks time) { return automata::format_seconds(time) + " s"; }

/// Where a location stands; the file only where there are several.
std::string place(const automata::Origin& origin, const ModelProgram& program) {
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
            place(location.origin, program);
  }
  return text;
}

std::string as_text(const Answer& answer, const ModelProgram& program) {
  std::ostringstream text;
  text << "at " << seconds_text(answer.time) << '\n';
  if (!answer.estimate.explained) text << "  " << what_went_wrong(answer.estimate) << '\n';
  if (answer.estimate.cut) text << "  the search ended early; the belief may lack markings\n";
  for (const MarkingEntry& entry : answer.belief) {
    text << "  " << entry.probability << "  " << in_words(entry.marking, program) << '\n';
    const std::string values = to_text(program.variables, entry.values);
    if (!values.empty()) text << "      " << values << '\n';
  }
  for (const MarkingTrajectory& trajectory : answer.history) {
    text << "  " << trajectory.probability << "  what happened:\n";
    for (std::size_t t = 0; t < trajectory.markings.size(); ++t) {
      text << "      at " << seconds_text(answer.times[t]) << "  " << in_words(trajectory.markings[t], program) << '\n';
    }
  }
  for (const Revision& revision : answer.revised) {
    text << "  revised: at " << seconds_text(revision.time) << "  " << in_words(revision.now, program)
         << "\n      in place of " << in_words(revision.before, program) << '\n';
  }
  return text.str();
}

/// Answers a log line by line.
class ModelFlight {
 public:
  ModelFlight(const ModelProgram& program, const ModelEstimateOptions& options)
      : program_(program), options_(options), estimator_(make_marking_estimator(program, options.estimator)) {
    if (!estimator_->estimate().possible) refuse_start(program, options.model);
  }

  std::optional<std::string> answer(const LogLine& line, const std::string& name) {
    Answer answer;
    try {
      const bool start = !begun_ && line.timed && line.is_of_start();
      if (start) {
        take_in(line.observations);
        estimator_->start(at_start_);
      } else {
        for (std::uint64_t i = 1; i <= line.unchanged; ++i) {
          if (interrupted()) return std::nullopt;
          const runtime::Stopwatch stopwatch;
          update(before_, line.time_of_unchanged(i));
          latency_.add(stopwatch.seconds());
        }
        const runtime::Stopwatch stopwatch;
        update(line, line.time);
        if (options_.estimator.window > 0) answer.history = estimator_->history();
        latency_.add(stopwatch.seconds());
      }
      answer.belief = estimator_->belief();
      if (options_.estimator.window > 0) tell_history(answer, start);
    } catch (const runtime::TooManyStates& error) {
      throw base::LimitError(name + ":" + std::to_string(line.number) + ": " + error.what() +
                             (options_.estimator.window > 0
                                  ? "; expected no --window, or independent groups of fewer states"
                                  : "; expected -k, to list the best of them, or --estimator k-best"));
    }
    answer.cycle = line.cycle;
    answer.time = line.time;
    answer.estimate = estimator_->estimate();
    cut_ = cut_ || answer.estimate.cut;
    before_ = line;
    return options_.text ? as_text(answer, program_) : as_json(answer, program_, options_.stats);
  }

  [[nodiscard]] bool cut() const { return cut_; }

  void report(double seconds) {
    std::ostringstream text;
    text << latency_.count() << " cycles, " << estimator_->groups() << " independent group"
         << (estimator_->groups() == 1 ? "" : "s") << ", " << estimator_->questions() << " questions to the store, "
         << estimator_->solver_calls() << " solver calls, " << seconds << " s\n";
    if (latency_.count() > 0) text << "a cycle: " << latency_.text() << '\n';
    print_error(text.str());
  }

 private:
  void update(const LogLine& told, Ticks time) {
    begun_ = true;
    estimator_->update(automata::command_from(program_, told.command), told.observations);
    ++updates_;
    times_.push_back(time);
    if (times_.size() > options_.estimator.window + 1) times_.erase(times_.begin());
  }

  void tell_history(Answer& answer, bool start) {
    answer.times = times_;
    if (start) answer.history = estimator_->history();
    if (answer.history.empty()) return;
    const std::vector<Marking>& now = answer.history.front().markings;
    const std::size_t first = updates_ + 1 - now.size();  // the update after which the trajectory sets out, or 0
    for (std::size_t t = 0; t < now.size(); ++t) {
      if (first + t < last_first_ || first + t >= last_first_ + last_.size()) continue;
      const Marking& before = last_[first + t - last_first_];
      if (before != now[t]) answer.revised.push_back({times_[t], before, now[t]});
    }
    last_ = now;
    last_first_ = first;
  }

  /// Of several readings of one variable at the start the last counts.
  void take_in(const automata::Observation& observation) {
    for (const automata::Assignment& reading : observation) {
      std::erase_if(at_start_, [&](const automata::Assignment& known) { return known.variable == reading.variable; });
      at_start_.push_back(reading);
    }
    std::sort(at_start_.begin(), at_start_.end());
  }

  const ModelProgram& program_;
  const ModelEstimateOptions& options_;
  std::unique_ptr<runtime::MarkingEstimator> estimator_;
  Latency latency_;
  bool begun_ = false;  ///< a step was taken
  bool cut_ = false;
  automata::Observation at_start_;
  LogLine before_;
  std::vector<Ticks> times_{Ticks{}};  ///< of the belief that the window sets out from, and of each update since
  std::size_t updates_ = 0;
  std::vector<Marking> last_;   ///< the most likely trajectory after the line before
  std::size_t last_first_ = 0;  ///< the update after which that sets out
};

}  // namespace

ExitStatus estimate_model(const ModelProgram& program, const ModelEstimateOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  watch_for_interruption();
  const auto lines = check_log(options.log, program);
  ModelFlight flight(program, options);
  const bool early = answer_log(options.log, program, lines, [&](const LogLine& line, const std::string& name) {
    return flight.answer(line, name);
  });
  if (flight.cut()) tell("a search was cut short; a belief may lack markings");
  if (options.stats) flight.report(seconds_since(begin));
  return early ? ExitStatus::undecided : ExitStatus::done;
}

}  // namespace rmpl::tools
