// rmpl-run scenario: flies scenarios, tells their stories and judges them.
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "runtime/executive/scenario/report.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/executive/scenario/story.hpp"
#include "runtime/executive/trace/trace_writer.hpp"
#include "tools/rmpl-run/command.hpp"
#include "tools/rmpl-run/input.hpp"
#include "tools/rmpl-run/latency.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/progress.hpp"

namespace rmpl::runtime {
namespace {

using base::InputError;
using Engine = ScenarioOptions::Engine;
using Recovery = ScenarioOptions::Recovery;

struct Options {
  std::string file;
  std::string only;
  std::string trace;
  TraceDetail detail = TraceDetail::changes;
  std::vector<std::string> components;
  automata::Ticks from;
  automata::Ticks to = automata::Ticks::infinite();
  std::optional<std::uint64_t> seed;
  Format format = Format::text;
  Engine engine = Engine::k_best;
  Recovery recovery = Recovery::planner;
  std::size_t k = 16;
  bool real_time = false;
  bool stats = false;
};

constexpr const char* footer = R"(A scenario names a control program, a plant, what happens and what is expected.
By default it is told as a story while it flies, one line for each thing that changes.

exit code: 0 all expectations are met; 1 one failed; 2 an input is wrong; 3 interrupted

examples:
  rmpl-run scenario nominal.scn                    the story, and the verdicts
  rmpl-run scenario nominal.scn --trace out.jsonl  what changes, as JSON Lines
  rmpl-run scenario faults.scn --only 'pde reset'  one scenario of several
  rmpl-run scenario dice.scn --seed 42             another draw of the same plant
  rmpl-run scenario landing.scn --only-component engine --from 4.5h --to 5h)";

/// Adds up what the cycles of a flight cost.
class Account : public CycleObserver {
 public:
  void observe(const CycleRecord& record) override {
    if (record.cycle == 0) return;
    estimation_.add(record.checked, record.estimation_seconds);
    reconfiguration_.add(record.considered, record.reconfiguration_seconds);
    both_.add(record.estimation_seconds + record.reconfiguration_seconds);
  }
  void report(const std::string& scenario, double seconds) const {
    std::cerr << scenario << ": " << both_.count() << " cycles in " << seconds << " s\n";
    if (both_.count() == 0) return;
    std::cerr << "  estimation: " << estimation_.text() << "\n  reconfiguration: " << reconfiguration_.text()
              << "\n  both: " << both_.text() << '\n';
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
      return std::to_string(checked) + " candidates checked, " + std::to_string(most) + " at most in a cycle; " +
             latency.text();
    }
  };
  Engine estimation_, reconfiguration_;
  Latency both_;
};

/// What is wrong with a seed, or nothing: the parser by itself would wrap a negative one around.
std::string seed_error(const std::string& text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, seed);
  if (parsed.ec == std::errc{} && parsed.ptr == end) return {};
  return "expected a whole number from 0 to 2^64 - 1, not '" + text + "'";
}

std::vector<const automata::Scenario*> selected(const automata::Document& document, const Options& options) {
  if (document.scenarios.empty())
    throw base::InputError(options.file + ": expected a scenario, and there is none in it");
  std::vector<const automata::Scenario*> result;
  std::vector<std::string_view> names;
  for (const automata::Scenario& scenario : document.scenarios) {
    names.emplace_back(scenario.name);
    if (options.only.empty() || scenario.name == options.only) result.push_back(&scenario);
  }
  if (result.empty()) {
    throw base::InputError(options.file + ": no scenario is called '" + options.only + "'" +
                           base::suggestion(options.only, names));
  }
  if (result.size() > 1 && !options.trace.empty()) {
    throw base::InputError("--trace holds one scenario, and " + options.file + " has " + std::to_string(result.size()) +
                           "; choose one with --only");
  }
  return result;
}

/// What reconfiguration computes beforehand, once for each plant.
using Graphs = std::map<std::size_t, std::shared_ptr<const NominalGraph>>;

StoryFocus focus_of(const Options& options, const automata::Plant& plant) {
  StoryFocus focus{{}, options.from, options.to};
  std::vector<std::string_view> names;
  for (const automata::Component& component : plant.components) names.emplace_back(component.name);
  for (const std::string& name : options.components) {
    const auto component = plant.find_component(name);
    if (!component) {
      throw base::InputError("--only-component: plant '" + plant.name + "' has no component '" + name + "'" +
                             base::suggestion(name, names));
    }
    focus.components.push_back(*component);
  }
  return focus;
}

/// Flies one scenario, and tells its story to standard output as it happens.
ScenarioResult fly(const automata::Document& document, const automata::Scenario& scenario, const Options& options,
                   const Common& common, Graphs& graphs) {
  const automata::Plant& plant = document.plants[scenario.plant];
  const automata::Program& program = document.programs[scenario.program];
  const Style style{common.color_output()};
  const auto tell = [&](const std::string& line) { std::cout << line << std::endl; };
  std::vector<CycleObserver*> observers;
  const MomentColumn column(scenario.duration, options.real_time ? automata::Ticks{1} : scenario.cycle);
  Story story(plant, program, column, style, focus_of(options, plant), tell);
  const bool told = options.format == Format::text && !common.quiet;
  if (told) {
    tell(heading(document, scenario, options.seed.value_or(scenario.seed), style));
    observers.push_back(&story);
  }
  std::optional<TraceWriter> trace;
  if (!options.trace.empty()) observers.push_back(&trace.emplace(plant, program, options.trace, options.detail));
  // A story on the terminal is its own progress.
  Progress progress(scenario.name, scenario.duration, !common.quiet && !(told && isatty(STDOUT_FILENO) != 0));
  observers.push_back(&progress);
  Account account;
  observers.push_back(&account);

  ScenarioOptions run;
  run.seed = options.seed;
  run.engine = options.engine;
  run.recovery = options.recovery;
  auto& graph = graphs[scenario.plant];
  if (!graph) graph = reconfiguration_graph(plant);
  run.graph = graph;
  run.k = options.k;
  run.real_time = options.real_time;
  run.interrupted = interrupted;
  const auto begin = std::chrono::steady_clock::now();
  const ScenarioResult result = run_scenario(document, scenario, run, observers);
  if (options.stats || common.verbose) account.report(scenario.name, seconds_since(begin));
  if (trace) trace->keep();
  if (options.format == Format::text) {
    std::cout << (common.quiet ? scenario.name + ": " : "\n") << summary(scenario, result, style) << std::flush;
  }
  return result;
}

/// An option that takes a time of the flight.
void add_time(CLI::App& app, const std::string& name, automata::Ticks& time, const std::string& description) {
  const auto take = [name, &time](const std::string& text) {
    const auto parsed = automata::parse_duration(text);
    if (!parsed) {
      throw CLI::ValidationError(
          name, "expected seconds or a duration in us, ms, s, min, h or d, as in 4.5h, not '" + text + "'");
    }
    time = *parsed;
  };
  app.add_option_function<std::string>(name, take, description)->option_text("TIME");
}

Status status_of(Judgement::Verdict verdict) {
  switch (verdict) {
    case Judgement::Verdict::met:
      return Status::done;
    case Judgement::Verdict::failed:
      return Status::failed;
    case Judgement::Verdict::undecided:
      return Status::undecided;
  }
  return Status::undecided;
}

/// A failure outweighs what is undecided, and that outweighs success.
Status worse(Status a, Status b) {
  if (a == Status::failed || b == Status::failed) return Status::failed;
  return a == Status::done ? b : a;
}

Status run(const Options& options, const Common& common) {
  const auto compilation = load({options.file}, common);
  if (!compilation) return Status::wrong;
  const automata::Document& document = compilation->document();
  if (const auto input = compilation->input_at(options.trace)) {
    throw base::InputError("--trace would overwrite an input, " + *input);
  }
  watch_for_interruption();
  Status status = Status::done;
  Graphs graphs;
  JsonLine json;
  json.open('{').key("scenarios").open('[');
  bool told_before = false;
  for (const automata::Scenario* scenario : selected(document, options)) {
    if (told_before && !common.quiet && options.format == Format::text) std::cout << '\n';
    told_before = true;
    const ScenarioResult result = fly(document, *scenario, options, common, graphs);
    write_result(json, *scenario, result);
    status = worse(status, status_of(result.verdict()));
    if (result.interrupted) break;
  }
  json.close(']').close('}');
  if (options.format == Format::json) std::cout << json.text() << '\n';
  finish_output();
  return status;
}

}  // namespace

Subcommand scenario_command(CLI::App& app, const Common& common) {
  CLI::App* command = app.add_subcommand("scenario", "fly a scenario: the executive on a simulated plant");
  const auto options = std::make_shared<Options>();
  command->add_option("FILE", options->file, "a .scn file, or a compiled .json")->required();
  command->add_option("--only", options->only, "run this scenario of the file only")->option_text("NAME");
  command->add_option("--trace", options->trace, "write what happens, as JSON Lines")->option_text("OUT.jsonl");
  add_choice<TraceDetail>(
      *command, "--trace-detail", options->detail,
      {{"changes", TraceDetail::changes}, {"cycles", TraceDetail::cycles}, {"beliefs", TraceDetail::beliefs}},
      "what the trace tells: cycles in which something changes, every cycle,\n"
      "or every cycle with all states that are tracked (default: changes)");
  command
      ->add_option("--only-component", options->components,
                   "tell only what is about this component; may be given several times")
      ->option_text("NAME")
      ->take_all();
  add_time(*command, "--from", options->from, "tell the story from this time on");
  add_time(*command, "--to", options->to, "tell the story up to this time");
  command->add_option("--seed", options->seed, "draw the plant with this seed instead of the scenario's")
      ->option_text("N")
      ->check(seed_error);
  add_format(*command, options->format);
  add_choice<Engine>(*command, "--estimator", options->engine, {{"exact", Engine::exact}, {"k-best", Engine::k_best}},
                     "how the executive estimates (default: k-best)");
  add_k(*command, options->k);
  add_choice<Recovery>(*command, "--reconfigurer", options->recovery,
                       {{"planner", Recovery::planner}, {"one-step", Recovery::one_step}},
                       "how the executive finds commands (default: planner)");
  command->add_flag("--real-time", options->real_time, "let each cycle take as long as it says");
  command->add_flag("--stats", options->stats,
                    "say on standard error how long cycles took: estimation, reconfiguration, both");
  command->footer(footer);
  return {command, [options, &common] { return run(*options, common); }};
}

}  // namespace rmpl::runtime
