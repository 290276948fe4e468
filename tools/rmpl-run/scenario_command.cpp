// rmpl-run scenario: flies scenarios, tells their stories and judges them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "runtime/executive/scenario/report.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/executive/scenario/story.hpp"
#include "runtime/executive/trace/trace_writer.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/latency.hpp"
#include "tools/rmpl-run/scenario_junit.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/progress.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

using runtime::CycleObserver;
using runtime::CycleRecord;
using runtime::JsonLine;
using runtime::Judgement;
using runtime::NominalGraph;
using runtime::ScenarioOptions;
using runtime::ScenarioResult;
using runtime::TraceDetail;
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
    std::ostringstream text;
    text << scenario << ": " << both_.count() << " cycles in " << seconds << " s\n";
    if (both_.count() > 0) {
      text << "  estimation: " << estimation_.text() << "\n  reconfiguration: " << reconfiguration_.text()
           << "\n  both: " << both_.text() << '\n';
    }
    print_error(text.str());
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

/// The line of progress of a flight.
class Progress final : public CycleObserver {
 public:
  Progress(std::string name, automata::Ticks duration, bool wanted)
      : name_(std::move(name)), duration_(duration), shown_(wanted) {}

  void observe(const CycleRecord& record) override {
    constexpr std::uint64_t cycles_between_looks = 64;  // asking the clock each time would cost more than a cycle
    constexpr auto pace = std::chrono::milliseconds(100);
    if (!shown_ || record.cycle % cycles_between_looks != 0) return;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + pace;
    show_progress(name_ + ": " + automata::format_seconds(record.time) + " s of at most " +
                  automata::format_seconds(duration_) + " s");
  }

 private:
  static constexpr auto patience = std::chrono::milliseconds(500);  // most flights are over by then
  std::string name_;
  automata::Ticks duration_;
  bool shown_;
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + patience;
};

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
                           suggestion_or_list(options.only, names));
  }
  if (result.size() > 1 && !options.trace.empty()) {
    throw base::InputError("--trace holds one scenario, and " + options.file + " has " + std::to_string(result.size()) +
                           "; choose one with --only");
  }
  return result;
}

/// What reconfiguration computes beforehand, once for each plant.
using Graphs = std::map<std::size_t, std::shared_ptr<const NominalGraph>>;

runtime::StoryFocus focus_of(const Options& options, const automata::Plant& plant) {
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

/// Flies one scenario, and tells its story to standard output as it happens.
Flown fly(const automata::Document& document, const automata::Scenario& scenario, const Options& options,
          const Common& common, Graphs& graphs) {
  const automata::Plant& plant = document.plants[scenario.plant];
  const automata::Program& program = document.programs[scenario.program];
  const base::Painter painter = output_painter(common.color);
  const auto tell_line = [](const std::string& line) { print(line + "\n"); };
  std::vector<CycleObserver*> observers;
  const runtime::MomentColumn column(scenario.duration, options.real_time ? automata::Ticks{1} : scenario.cycle);
  runtime::Story story(plant, program, column, painter, focus_of(options, plant), tell_line);
  std::optional<runtime::TraceWriter> trace;
  if (!options.trace.empty()) trace.emplace(plant, program, options.trace, options.detail);
  const bool told = common.format == Format::text && !common.quiet;
  if (told) {
    tell_line(runtime::heading(document, scenario, options.seed.value_or(scenario.seed), painter));
    observers.push_back(&story);
  }
  if (trace) observers.push_back(&*trace);
  // A story on the terminal is its own progress.
  Progress progress(scenario.name, scenario.duration, progress_is_seen(common.quiet) && !(told && output_is_seen()));
  observers.push_back(&progress);
  Account account;
  observers.push_back(&account);

  ScenarioOptions run;
  run.seed = options.seed;
  run.engine = options.engine;
  run.recovery = options.recovery;
  auto& graph = graphs[scenario.plant];
  if (!graph) graph = runtime::reconfiguration_graph(plant);
  run.graph = graph;
  run.k = options.k;
  run.real_time = options.real_time;
  run.interrupted = interrupted;
  const auto begin = std::chrono::steady_clock::now();
  ScenarioResult result = runtime::run_scenario(document, scenario, run, observers);
  const double seconds = seconds_since(begin);
  if (options.stats || common.verbose) account.report(scenario.name, seconds);
  if (trace) trace->keep();
  if (common.format == Format::text) {
    print((common.quiet ? scenario.name + ": " : "\n") + runtime::summary(scenario, result, painter));
  }
  return {&scenario, std::move(result), seconds};
}

ExitStatus status_of(Judgement::Verdict verdict) {
  switch (verdict) {
    case Judgement::Verdict::met:
      return ExitStatus::done;
    case Judgement::Verdict::failed:
      return ExitStatus::violated;
    case Judgement::Verdict::undecided:
      return ExitStatus::undecided;
  }
  return ExitStatus::undecided;
}

/// A failure outweighs what is undecided, and that outweighs success.
ExitStatus worse(ExitStatus a, ExitStatus b) {
  if (a == ExitStatus::violated || b == ExitStatus::violated) return ExitStatus::violated;
  return a == ExitStatus::done ? b : a;
}

std::string to_json(const std::vector<Flown>& flights) {
  JsonLine json;
  json.open('{').key("scenarios").open('[');
  for (const Flown& flown : flights) runtime::write_result(json, *flown.scenario, flown.result);
  json.close(']').close('}');
  return json.text() + "\n";
}

ExitStatus run(const Options& options, const Common& common) {
  const compiler::Compilation compilation = load({options.file}, common);
  const automata::Document& document = compilation.document();
  watch_for_interruption();
  ExitStatus status = ExitStatus::done;
  Graphs graphs;
  std::vector<Flown> flights;
  for (const automata::Scenario* scenario : selected(document, options)) {
    if (!flights.empty() && !common.quiet && common.format == Format::text) print("\n");
    flights.push_back(fly(document, *scenario, options, common, graphs));
    status = worse(status, status_of(flights.back().result.verdict()));
    if (flights.back().result.interrupted) break;
  }
  switch (common.format) {
    case Format::text:
      break;
    case Format::json:
      print(to_json(flights));
      break;
    case Format::junit:
      print(to_junit(options.file, flights));
      break;
  }
  return status;
}

}  // namespace

void add_scenario(Program& program) {
  CLI::App* command = program.app().add_subcommand("scenario", "fly a scenario: the executive on a simulated plant");
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
      ->expected(1)
      ->take_all();
  add_read(*command, "--from", options->from, duration, "tell the story from this time on")->option_text("TIME");
  add_read(*command, "--to", options->to, duration, "tell the story up to this time")->option_text("TIME");
  add_whole_number(*command, "--seed", options->seed, 0, std::numeric_limits<std::uint64_t>::max(),
                   "draw the plant with this seed instead of the scenario's");
  add_format(*command, program.common(), true);
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
  program.add({command,
               [options, &common = program.common()] { return within_limits([&] { return run(*options, common); }); }});
}

}  // namespace rmpl::tools
