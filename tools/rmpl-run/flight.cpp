// A flight with its observers.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/flight.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <sstream>
#include <string_view>

#include "base/error.hpp"
#include "runtime/executive/scenario/report.hpp"
#include "runtime/executive/scenario/story.hpp"
#include "runtime/report/recorder.hpp"
#include "tools/rmpl-run/follow.hpp"
#include "tools/rmpl-run/latency.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/progress.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

using runtime::CycleObserver;
using runtime::CycleRecord;

/// Adds up what the cycles of a flight cost.
class Account final : public CycleObserver {
 public:
  void observe(const CycleRecord& record) override {
    if (record.cycle == 0) return;
    estimation_.add(record.checked, record.estimation_seconds);
    reconfiguration_.add(record.considered, record.reconfiguration_seconds);
    both_.add(record.estimation_seconds + record.reconfiguration_seconds);
  }
  [[nodiscard]] std::string text(const std::string& scenario, double seconds) const {
    std::ostringstream text;
    text << scenario << ": " << both_.count() << " cycles in " << seconds << " s\n";
    if (both_.count() > 0) {
      text << "  estimation: " << estimation_.text() << "\n  reconfiguration: " << reconfiguration_.text()
           << "\n  both: " << both_.text() << '\n';
    }
    return std::move(text).str();
  }

 private:
  struct Engine {
    std::size_t checked = 0, most = 0;  ///< candidates: over all cycles, in one
    Latency latency;

    void add(std::size_t candidates, double seconds) {
      checked += candidates;
      most = std::max(most, candidates);
      latency.add(seconds);
    }
    [[nodiscard]] std::string text() const {
      return std::to_string(checked) + " candidates checked, " + std::to_string(most) + " at most per cycle; " +
             latency.text();
    }
  };
  Engine estimation_, reconfiguration_;
  Latency both_;
};

/// The line of progress of the flight that has the word.
class Progress final : public CycleObserver {
 public:
  Progress(std::string name, automata::Ticks duration, InTurn& voices, std::size_t position)
      : name_(std::move(name)), duration_(duration), voices_(voices), position_(position) {}

  void observe(const CycleRecord& record) override {
    constexpr auto pace = std::chrono::milliseconds(100);
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + pace;
    if (!voices_.has_the_word(position_)) return;
    show_progress(name_ + ": " + automata::format_seconds(record.time) + " s of at most " +
                  automata::format_seconds(duration_) + " s");
  }

 private:
  static constexpr auto patience = std::chrono::milliseconds(500);  // most flights are over by then
  std::string name_;
  automata::Ticks duration_;
  InTurn& voices_;
  std::size_t position_;
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + patience;
};

runtime::StoryFocus focus_of(const FlightOptions& options, const automata::Plant& plant) {
  runtime::StoryFocus focus{{}, options.from, options.to};
  std::vector<std::string_view> names;
  for (const automata::Component& component : plant.components) names.emplace_back(component.name);
  for (const std::string& name : options.components) {
    const auto component = plant.find_component(name);
    if (!component) {
      throw base::InputError("--only-component: plant '" + plant.name + "' has no component '" + name + "'" +
                             suggestion_or_list(name, names));
    }
    focus.components.push_back(*component);
  }
  return focus;
}

runtime::ScenarioOptions run_options(const Task& task, const FlightOptions& options) {
  runtime::ScenarioOptions run;
  run.seed = options.seed;
  run.engine = options.engine;
  run.recovery = options.recovery;
  run.graph = task.graph;
  run.k = options.k;
  run.real_time = options.real_time;
  run.interrupted = interrupted;
  return run;
}

}  // namespace

Flown fly(const Task& task, const FlightOptions& options, const Common& common, InTurn& voices, std::size_t position,
          std::size_t count) {
  const automata::Scenario& scenario = *task.scenario;
  const automata::Plant& plant = task.document->plant_of(scenario);
  const automata::Program& program = task.document->programs[scenario.program];
  const base::Painter painter = output_painter(common.color);
  const auto tell = [&](const std::string& text) { voices.say(position, InTurn::To::output, text); };
  const bool told = options.tells_stories(common);
  const bool followed = told && options.follow && output_is_seen();

  std::vector<CycleObserver*> observers;
  const runtime::MomentColumn column(scenario.duration, scenario.cycle);
  runtime::Story story(plant, program, column, painter, focus_of(options, plant),
                       [&](const std::string& line) { tell(line + "\n"); });
  if (told && position > 0) tell("\n");
  if (told) tell(runtime::heading(*task.document, scenario, options.seed.value_or(scenario.seed), painter) + "\n");
  if (told && !followed) observers.push_back(&story);
  std::optional<FollowScreen> screen;
  if (followed) observers.push_back(&screen.emplace(plant, program, scenario, painter));
  std::optional<runtime::TraceWriter> trace;
  if (!options.trace.empty()) {
    observers.push_back(&trace.emplace(plant, program, options.trace, options.detail, options.keyframe));
  }
  // A story on the terminal is its own progress.
  const std::string which =
      count > 1 ? "[" + std::to_string(position + 1) + "/" + std::to_string(count) + "] " : std::string();
  Progress progress(which + scenario.name, scenario.duration, voices, position);
  if (progress_is_seen(common.quiet) && !(told && output_is_seen())) observers.push_back(&progress);
  std::optional<runtime::Recorder> recorder;
  if (options.records()) observers.push_back(&recorder.emplace(*task.document, scenario));
  std::optional<runtime::Coverage> coverage;
  if (!options.coverage.empty()) observers.push_back(&coverage.emplace(&plant, &program));
  Account account;
  const bool accounted = options.stats || common.verbose;
  if (accounted) observers.push_back(&account);

  const auto begin = std::chrono::steady_clock::now();
  runtime::ScenarioOptions run = run_options(task, options);
  run.measured = accounted;
  runtime::ScenarioResult result = runtime::run_scenario(*task.document, scenario, run, observers);
  const double seconds = seconds_since(begin);
  if (screen) screen->finish();
  if (accounted) voices.say(position, InTurn::To::error, account.text(scenario.name, seconds));
  if (trace) trace->keep();
  if (told || (common.format == Format::text && common.quiet && options.files.size() == 1)) {
    tell((common.quiet ? scenario.name + ": " : "\n") + runtime::summary(scenario, result, painter));
  }
  std::optional<runtime::Flight> data;
  if (recorder) data = recorder->finish(result);
  Flown flown{&scenario, std::move(result), seconds, std::move(data)};
  if (coverage) flown.coverage = coverage->items();
  return flown;
}

}  // namespace rmpl::tools
