// rmpl-run estimate: commands and observations in, beliefs out.
// SPDX-License-Identifier: MIT
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <vector>

#include "automata/error.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/command/command.hpp"
#include "runtime/command/input.hpp"
#include "runtime/command/interruption.hpp"
#include "runtime/estimate/estimator.hpp"
#include "runtime/trace/json_line.hpp"
#include "runtime/trace/log.hpp"
#include "runtime/trace/trace_writer.hpp"

namespace runtime {
namespace {

enum class Engine { exact, k_best };

struct Options {
  std::string plant;
  std::string log;
  Engine engine = Engine::k_best;
  std::optional<std::size_t> k;
  bool thesis = false;
  bool stats = false;
};

constexpr const char* footer =
    R"(Each line of the log is a JSON object: "time" in seconds, the "command" that was in force since the
line before (absent variables are idle), and the "observations" at that time. For each a line comes out:
"time", the most likely modes as "estimate", and the whole "belief", most probable first, with clocks in
seconds since they started. The first step is from time 0 and the initial distribution. A trace of
rmpl-run scenario is such a log; its first line, cycle 0, states where the run starts and is no step.

exit code: 0 done; 2 an input is wrong, and nothing was written; 3 interrupted

examples:
  rmpl-run estimate lander.tcca --log flight.jsonl
  rmpl-run estimate lander.tcca --log flight.jsonl --estimator exact
  echo '{"time": 0.5, "command": {"engine.cmd": "standby"}}' | rmpl-run estimate lander.tcca --log -)";

std::unique_ptr<Estimator> make_estimator(automata::PlantStep& step, const Options& options) {
  EstimatorOptions estimator;
  if (options.k) estimator.k = *options.k;
  estimator.merge_trajectories = estimator.observation_factor = estimator.normalise = !options.thesis;
  switch (options.engine) {
    case Engine::exact:
      return make_exact_estimator(step, estimator);
    case Engine::k_best:
      return make_k_best_estimator(step, estimator);
  }
  return nullptr;
}

void write(JsonLine& json, const LogLine& line, const Estimator& estimator, const automata::Plant& plant) {
  const Estimate& estimate = estimator.estimate();
  json.clear();
  json.open('{');
  if (line.cycle) json.key("cycle").number(*line.cycle);
  json.key("time").seconds(line.time).key("estimate").modes(estimate.modes, plant);
  json.key("belief").belief(estimator.belief(), plant, line.time);
  if (!estimate.consistent) {
    json.key("events");
    write_events(
        json,
        {{Event::Kind::inconsistent, "no state that is tracked explains the observations", std::nullopt, std::nullopt}},
        &plant);
  }
  json.close('}');
}

Status run(const Options& options, const Common& common) {
  const auto begin = std::chrono::steady_clock::now();
  check_standard_input({options.plant, options.log});
  const auto compilation = load({options.plant}, common);
  if (!compilation) return Status::wrong;
  const automata::Plant& plant = only_plant(compilation->document(), options.plant);
  TextInput input(options.log);
  // The log is read and checked in full before anything is printed.
  const std::vector<LogLine> lines = read_log(input.stream(), input.name(), plant);
  watch_for_interruption();

  automata::PlantStep step(plant);
  const auto estimator = make_estimator(step, options);
  if (estimator->belief().empty()) {
    throw automata::InputError(options.plant +
                               ": no initial state is possible: the initial modes contradict the interconnections");
  }
  JsonLine json;
  std::size_t checked = 0;
  bool cut = false;
  for (const LogLine& line : lines) {
    if (interrupted()) break;
    const bool start = line.cycle == 0 && line.time == automata::Ticks{};  // a trace begins with where it starts
    if (!start) {
      const Estimate& estimate =
          estimator->update(automata::action_from(plant, line.command), line.observations, line.time);
      checked += estimate.checked;
      cut = cut || estimate.cut;
    }
    write(json, line, *estimator, plant);
    std::cout << json.text() << '\n';
  }
  finish_output();
  if (cut) std::cerr << "rmpl-run: a search was cut short by its limit of candidates; a belief may lack states\n";
  if (options.stats || common.verbose) {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    std::cerr << lines.size() << " lines, " << checked << " candidates checked, " << step.theory().solver_calls()
              << " solver calls, " << seconds.count() << " s\n";
  }
  return interrupted() ? Status::undecided : Status::done;
}

}  // namespace

Subcommand estimate_command(CLI::App& app, const Common& common) {
  CLI::App* command = app.add_subcommand("estimate", "tell what state a plant is in, from a log");
  const auto options = std::make_shared<Options>();
  command->add_option("PLANT", options->plant, "a .tcca or .rmpl model, or a compiled .json")->required();
  command->add_option("--log", options->log, "commands and observations; - is standard input")
      ->required()
      ->option_text("IN.jsonl");
  add_choice<Engine>(*command, "--estimator", options->engine, {{"exact", Engine::exact}, {"k-best", Engine::k_best}},
                     "the whole belief, or the best of it (default: k-best)");
  add_k(*command, options->k);
  command->add_flag("--thesis", options->thesis,
                    "k-best as Fig. 6-11 of the thesis has it: trajectories that meet are not added up, the\n"
                    "observation factor is not applied, and nothing is normalised");
  command->add_flag("--stats", options->stats, "say on standard error what it cost");
  command->footer(footer);
  return {command, [options, &common] {
            if (options->engine == Engine::exact && (options->thesis || options->k)) {
              throw automata::InputError("-k and --thesis are about k-best; expected --estimator k-best");
            }
            return run(*options, common);
          }};
}

}  // namespace runtime
