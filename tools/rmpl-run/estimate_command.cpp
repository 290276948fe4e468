// rmpl-run estimate: commands and observations in, beliefs out.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <sstream>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/limit_error.hpp"
#include "runtime/executive/cycle/stopwatch.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/executive/trace/trace_writer.hpp"
#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/latency.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

using runtime::Belief;
using runtime::Estimate;
using runtime::Estimator;
using runtime::Event;
using runtime::JsonLine;
using runtime::LogLine;

enum class Engine { exact, k_best };

struct Options {
  std::string plant;
  std::string log;
  Engine engine = Engine::k_best;
  std::optional<std::size_t> k;
  std::optional<automata::Ticks> deadline;
  bool thesis = false;
  bool stats = false;
};

/// What an update cost, and what it may have missed.
struct Cost {
  std::size_t checked = 0;
  double missing = 0;
};

constexpr const char* footer =
    R"(Each line of the log is a JSON object: "time" in seconds, the "command" that was in force since the
line before (absent variables are idle), and the "observations" at that time. For each a line comes out:
"time", the most likely modes as "estimate", and the "belief", most probable first, with clocks in
seconds since they started. The first step is from time 0 and the initial distribution. A trace of
rmpl-run scenario is such a log; its first line, cycle 0, states where the run starts and is no step.
Where a search ended early, the line says "cut": true, and its belief may lack states.
With --stats a line also has "checked", the candidates that were checked, and "missing_mass", an upper
bound of the probability of all states that it does not list.

exit code: 0 done; 2 an input is wrong, and nothing was written; 3 interrupted

examples:
  rmpl-run estimate lander.tcca --log flight.jsonl
  rmpl-run estimate lander.tcca --log flight.jsonl --estimator exact
  rmpl-run estimate lander.tcca --log flight.jsonl -k 64 --deadline 5ms --stats
  echo '{"time": 0.5, "command": {"engine.cmd": "standby"}}' | rmpl-run estimate lander.tcca --log -)";

std::unique_ptr<Estimator> make_estimator(automata::PlantStep& step, const Options& options) {
  runtime::EstimatorOptions estimator;
  if (options.k) estimator.k = estimator.listed = *options.k;
  if (options.deadline) estimator.deadline = std::chrono::nanoseconds(options.deadline->count);
  estimator.merge_trajectories = estimator.observation_factor = estimator.normalise = !options.thesis;
  switch (options.engine) {
    case Engine::exact:
      return runtime::make_exact_estimator(step, estimator);
    case Engine::k_best:
      return runtime::make_k_best_estimator(step, estimator);
  }
  return nullptr;
}

/// The head of a belief: all of it, but with `exact` no more than was asked for.
Belief listed(const Belief& belief, const Options& options) {
  const std::size_t most = options.engine == Engine::exact && options.k ? *options.k : belief.size();
  return {belief.begin(), belief.begin() + static_cast<std::ptrdiff_t>(std::min(belief.size(), most))};
}

void write(JsonLine& json, const LogLine& line, const Estimate& estimate, const Belief& belief, const Cost* cost,
           const automata::Plant& plant) {
  json.clear();
  json.open('{');
  if (line.cycle) json.key("cycle").number(*line.cycle);
  json.key("time").seconds(line.time).key("estimate").modes(estimate.modes, plant);
  json.key("belief").belief(belief, plant, line.time);
  if (estimate.cut) json.key("cut").boolean(true);
  if (cost != nullptr) json.key("checked").number(cost->checked).key("missing_mass").number(cost->missing);
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

/// An upper bound of the probability of what a line does not list. A belief that is listed in full adds up to 1 but for
/// rounding.
double unlisted(const Estimate& estimate, const Belief& belief) {
  constexpr double rounding = 1e-12;
  const double missing = 1 - (1 - estimate.missing_total) * std::min(1.0, runtime::total(belief));
  return missing > rounding ? missing : estimate.missing_total;
}

/// What it cost, over all updates.
struct Account {
  Latency latency;
  std::size_t checked = 0;
  double missing = 0;  ///< the most in any line
};

void report(const Account& account, const Estimator& estimator, double seconds) {
  const std::size_t groups = estimator.groups();
  std::ostringstream text;
  text << account.latency.count() << " cycles, " << groups << " independent group" << (groups == 1 ? "" : "s") << ", "
       << account.checked << " candidates checked, " << estimator.questions() << " questions to the store, "
       << estimator.solver_calls() << " solver calls, " << seconds << " s\n";
  if (account.latency.count() > 0) text << "a cycle: " << account.latency.text() << '\n';
  text << "missing mass: at most " << account.missing << '\n';
  print_error(text.str());
}

ExitStatus run(const Options& options, const Common& common) {
  const auto begin = std::chrono::steady_clock::now();
  check_standard_input({options.plant, options.log});
  const compiler::Compilation compilation = load({options.plant}, common);
  const automata::Plant& plant = only_plant(compilation.document(), options.plant);
  base::InputFile input(options.log);
  // The log is read and checked in full before anything is printed.
  const std::vector<LogLine> lines = runtime::read_log(input.stream(), input.name(), plant);
  watch_for_interruption();

  automata::PlantStep step(plant);
  const auto estimator = make_estimator(step, options);
  if (!estimator->estimate().consistent) {
    throw base::InputError(options.plant +
                           ": no initial state is possible: the initial modes contradict the interconnections");
  }
  JsonLine json;
  Account account;
  bool cut = false;
  std::size_t answered = 0;
  const LogLine* before = nullptr;
  for (const LogLine& line : lines) {
    if (interrupted()) break;
    const bool start = line.cycle == 0 && line.time == automata::Ticks{};  // a trace begins with where it starts
    Belief belief;
    try {
      if (!start) {
        const auto update = [&](const LogLine& told, automata::Ticks time) {
          const automata::ControlAction action = automata::action_from(plant, told.command);
          const runtime::Stopwatch stopwatch;
          estimator->update(action, told.observations, time);
          account.latency.add(stopwatch.seconds());
        };
        // Cycles that were left out went as the line before says.
        for (std::uint64_t i = 1; i <= line.unchanged && !interrupted(); ++i) {
          update(*before, line.time_of_unchanged(i));
        }
        update(line, line.time);
      }
      before = &line;
      belief = listed(estimator->belief(), options);
    } catch (const runtime::TooManyStates& error) {
      throw base::LimitError(input.name() + ":" + std::to_string(line.number) + ": " + error.what() +
                             "; expected -k, to list the best of them, or --estimator k-best");
    }
    const Estimate& estimate = estimator->estimate();
    const Cost cost{estimate.checked, unlisted(estimate, belief)};
    if (!start) {
      cut = cut || estimate.cut;
      account.checked += cost.checked;
      account.missing = std::max(account.missing, cost.missing);
    }
    write(json, line, estimate, belief, options.stats && !start ? &cost : nullptr, plant);
    print(std::string(json.text()) + "\n");  // whole lines, whatever ends the run
    ++answered;
  }
  if (interrupted() && answered < lines.size()) {
    tell("interrupted after " + std::to_string(answered) + " of " + std::to_string(lines.size()) + " lines");
  }
  if (cut) tell("a search was cut short; a belief may lack states");
  if (options.stats || common.verbose) report(account, *estimator, seconds_since(begin));
  return answered < lines.size() ? ExitStatus::undecided : ExitStatus::done;
}

}  // namespace

void add_estimate(Program& program) {
  CLI::App* command = program.app().add_subcommand("estimate", "tell what state a plant is in, from a log");
  const auto options = std::make_shared<Options>();
  command->add_option("PLANT", options->plant, "a .tcca model, or a compiled .json")->required();
  command->add_option("--log", options->log, "commands and observations; - is standard input")
      ->required()
      ->option_text("IN.jsonl");
  add_choice<Engine>(*command, "--estimator", options->engine, {{"exact", Engine::exact}, {"k-best", Engine::k_best}},
                     "the whole belief, or the best of it (default: k-best)");
  add_k(*command, options->k);
  add_read(*command, "--deadline", options->deadline, positive_duration,
           "how long one update may search; the best states found until then are kept")
      ->option_text("TIME");
  command->add_flag("--thesis", options->thesis,
                    "k-best as Fig. 6-11 of the thesis has it: trajectories that meet are not added up, the\n"
                    "observation factor is not applied, and nothing is normalised");
  command->add_flag("--stats", options->stats, "say on standard error what it cost");
  command->footer(footer);
  program.add({command, [options, &common = program.common()] {
                 if (options->engine == Engine::exact && (options->thesis || options->deadline)) {
                   throw base::InputError("--thesis and --deadline are about k-best; expected --estimator k-best");
                 }
                 return within_limits([&] { return run(*options, common); });
               }});
}

}  // namespace rmpl::tools
