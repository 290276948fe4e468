// rmpl-run scenario: flies scenarios, tells their stories and judges them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <string_view>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "runtime/executive/scenario/report.hpp"
#include "runtime/report/exports.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/flights.hpp"
#include "tools/rmpl-run/scenario_junit.hpp"
#include "tools/rmpl-run/scenario_model.hpp"
#include "tools/rmpl-run/scenario_table.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/report_file.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

using runtime::JsonLine;
using runtime::Judgement;
using runtime::TraceDetail;
using Engine = runtime::ScenarioOptions::Engine;
using Recovery = runtime::ScenarioOptions::Recovery;

constexpr const char* footer = R"(A scenario names a control program, a plant, what happens and what is expected.
Those of one file are told as stories while they fly, a line for each thing that changes; those of
several files as a table, with what was not met and why (-v tells their stories, too).

exit code: 0 all expectations are met; 1 one failed; 2 an input is wrong; 3 interrupted

examples:
  rmpl-run scenario nominal.scn                    the story, and the verdicts
  rmpl-run scenario nominal.scn --follow           the flight on the terminal as it goes on
  rmpl-run scenario *.scn --junit out.xml          a table of verdicts, and a file for the CI
  rmpl-run scenario nominal.scn --report out.html  a page to look at it in a browser
  rmpl-run scenario nominal.scn --trace out.jsonl  what changes, as JSON Lines
  rmpl-run scenario faults.scn --only 'pde reset'  one scenario of several
  rmpl-run scenario dice.scn --seed 42             another draw of the same plant
  rmpl-run scenario landing.scn --only-component engine --from 4.5h --to 5h)";

/// The scenarios that were asked for, in the order of the files.
std::vector<Task> tasks_of(const std::vector<compiler::Compilation>& compilations, const FlightOptions& options) {
  std::vector<Task> result;
  std::vector<std::string_view> names;
  for (std::size_t f = 0; f < compilations.size(); ++f) {
    const automata::Document& document = compilations[f].document();
    if (document.scenarios.empty() && is_model_program(document)) {
      throw base::InputError(options.files[f] +
                             ": this is a model program: expected --commands, the list of commands to draw it under");
    }
    if (document.scenarios.empty())
      throw base::InputError(options.files[f] + ": expected a scenario, and there is none in it");
    // What reconfiguration computes beforehand, once for each plant.
    std::map<std::size_t, std::shared_ptr<const runtime::NominalGraph>> graphs;
    for (const automata::Scenario& scenario : document.scenarios) {
      names.emplace_back(scenario.name);
      if (!options.only.empty() &&
          std::find(options.only.begin(), options.only.end(), scenario.name) == options.only.end())
        continue;
      std::shared_ptr<const runtime::NominalGraph> graph;
      if (!scenario.model) {
        auto& known = graphs[scenario.plant];
        if (!known) known = runtime::reconfiguration_graph(document.plants[scenario.plant]);
        graph = known;
      }
      result.push_back({options.files[f], &document, &scenario, graph});
    }
  }
  const std::string files =
      options.files.size() == 1 ? options.files.front() : std::to_string(options.files.size()) + " files";
  const auto unknown = std::find_if(options.only.begin(), options.only.end(), [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) == names.end();
  });
  if (unknown != options.only.end()) {
    throw base::InputError(files + ": no scenario is called '" + *unknown + "'" + suggestion_or_list(*unknown, names));
  }
  for (const auto& [option, path] : {std::pair{"--trace", &options.trace}, std::pair{"--vcd", &options.vcd},
                                     std::pair{"--csv", &options.csv}, std::pair{"--mcap", &options.mcap}}) {
    if (result.size() <= 1 || path->empty()) continue;
    throw base::InputError(std::string(option) + " holds one scenario, and " + files +
                           (options.files.size() == 1 ? " has " : " have ") + std::to_string(result.size()) +
                           "; choose one with --only");
  }
  return result;
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

/// The files of one flight for tools of others. Names that cannot be written are told before the flight.
class Exports {
 public:
  explicit Exports(const FlightOptions& options) {
    if (!options.vcd.empty()) vcd_.emplace(options.vcd);
    if (!options.csv.empty()) csv_.emplace(options.csv);
    if (!options.mcap.empty()) mcap_.emplace(options.mcap);
  }
  void write(const runtime::Flight& flight) {
    const auto keep = [](std::optional<base::OutputFile>& file, const auto& text) {
      if (!file) return;
      file->write(text());
      file->keep();
    };
    keep(vcd_, [&] { return runtime::to_vcd(flight); });
    keep(csv_, [&] { return runtime::to_csv(flight); });
    keep(mcap_, [&] { return runtime::to_mcap(flight); });
  }

 private:
  std::optional<base::OutputFile> vcd_, csv_, mcap_;
};

std::vector<ReportFile::Subject> models_of(const std::vector<Task>& tasks) {
  std::vector<ReportFile::Subject> result;
  for (const Task& task : tasks) {
    const automata::Document& document = *task.document;
    result.push_back({&document.plant_of(*task.scenario), &document.programs[task.scenario->program]});
  }
  return result;
}

std::vector<runtime::Flight> data_of(std::vector<Flown>& flights) {
  std::vector<runtime::Flight> result;
  for (Flown& flown : flights) {
    if (flown.data) result.push_back(std::move(*flown.data));
  }
  return result;
}

std::string title_of(const FlightOptions& options) {
  const std::string first = options.files.front();
  return first.substr(first.rfind('/') + 1) + (options.files.size() > 1 ? " and others" : "");
}

/// A model program is no scenario: it is drawn from under a list of commands.
ExitStatus run_model(const FlightOptions& options, const Common& common) {
  if (options.files.size() > 1) throw base::InputError("--commands: expected one model program");
  check_standard_input({options.files.front(), options.commands});
  const compiler::Compilation compilation = load(options.files, common);
  const automata::ModelProgram& program = only_model_program(compilation.document(), options.files.front());
  return fly_model(program, options.files.front(), options.commands, options.seed.value_or(0));
}

ExitStatus run(const FlightOptions& options, const Common& common) {
  if (!options.commands.empty()) return run_model(options, common);
  check_standard_input(options.files);
  if (options.to < options.from) throw base::InputError("--to: expected a time that is not before --from");
  std::vector<compiler::Compilation> compilations;
  for (const std::string& file : options.files) compilations.push_back(load({file}, common));
  const std::vector<Task> tasks = tasks_of(compilations, options);
  std::optional<base::OutputFile> junit;
  if (!options.junit.empty()) junit.emplace(options.junit);  // a name that cannot be written is told at once
  watch_for_interruption();
  Exports exports(options);
  std::optional<ReportFile> report;
  if (!options.report.empty()) report.emplace(options.report, models_of(tasks));
  std::vector<Flown> flights = fly_all(tasks, options, common);
  switch (common.format) {
    case Format::text:
      if (tasks.size() > 1 && !common.quiet) {
        const bool stories = options.tells_stories(common);
        print((stories ? "\n" : "") + to_table(tasks, flights, !stories, output_painter(common.color)));
      }
      break;
    case Format::json:
      print(to_json(flights));
      break;
    case Format::junit:
      print(to_junit(tasks, flights));
      break;
  }
  if (junit) {
    junit->write(to_junit(tasks, flights));
    junit->keep();
  }
  if (!flights.empty() && flights.front().data) exports.write(*flights.front().data);
  if (report) report->write(title_of(options), data_of(flights));
  ExitStatus status = flights.size() < tasks.size() ? ExitStatus::undecided : ExitStatus::done;
  for (const Flown& flown : flights) status = worse(status, status_of(flown.result.verdict()));
  return status;
}

/// With --commands nothing flies: of the options the seed alone has a meaning.
void exclude_flights(CLI::App& command) {
  CLI::Option* list = command.get_option("--commands");
  for (CLI::Option* other : command.get_options()) {
    const bool general =
        other->get_positional() || other == list || other->check_name("--seed") || other->check_name("--help");
    if (!general) list->excludes(other);
  }
}

}  // namespace

void add_scenario(Program& program) {
  CLI::App* command = program.app().add_subcommand("scenario", "fly a scenario: the executive on a simulated plant");
  const auto options = std::make_shared<FlightOptions>();
  command->add_option("FILE", options->files, "files of scenarios: .scn, or compiled .json")->required();
  repeatable(command->add_option("--only", options->only, "run this scenario only; may be given several times")
                 ->option_text("NAME"));
  constexpr std::uint64_t most_jobs = 256;
  options->jobs = std::clamp(std::thread::hardware_concurrency(), 1u, static_cast<unsigned>(most_jobs));
  add_whole_number(*command, "--jobs,-j", options->jobs, 1, most_jobs,
                   "how many scenarios fly at once, with the same output for any number\n(default: one a core)");
  command->add_flag("--follow", options->follow, "show the flight on the terminal while it goes on, not its story");
  command->add_option("--trace", options->trace, "write what happens, as JSON Lines")->option_text("OUT.jsonl");
  command->add_option("--report", options->report, "write a page to look at the flights in a browser, all in one file")
      ->option_text("OUT.html");
  command->add_option("--vcd", options->vcd, "write a value change dump, for wave viewers")->option_text("OUT.vcd");
  command->add_option("--csv", options->csv, "write what changes as a table")->option_text("OUT.csv");
  command->add_option("--mcap", options->mcap, "write MCAP, for robotics tools")->option_text("OUT.mcap");
  command->add_option("--junit", options->junit, "write a test case for each expectation, for continuous integration")
      ->option_text("OUT.xml");
  add_choice<TraceDetail>(
      *command, "--trace-detail", options->detail,
      {{"changes", TraceDetail::changes}, {"cycles", TraceDetail::cycles}, {"beliefs", TraceDetail::beliefs}},
      "what the trace tells: cycles in which something changes, every cycle,\n"
      "or every cycle with all states that are tracked (default: changes)");
  repeatable(command
                 ->add_option("--only-component", options->components,
                              "tell only what is about this component; may be given several times")
                 ->option_text("NAME"));
  add_read(*command, "--from", options->from, duration, "tell the story from this time on")->option_text("TIME");
  add_read(*command, "--to", options->to, duration, "tell the story up to this time")->option_text("TIME");
  add_whole_number(*command, "--seed", options->seed, 0, std::numeric_limits<std::uint64_t>::max(),
                   "draw the plant with this seed instead of the scenario's");
  command
      ->add_option("--commands", options->commands,
                   "draw a model program under these commands, and print what happens as a log; the FILE is\n"
                   "then a .rmpl or .tcca file; - is standard input")
      ->option_text("IN.jsonl");
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
  exclude_flights(*command);
  command->footer(footer);
  program.add({command,
               [options, &common = program.common()] { return within_limits([&] { return run(*options, common); }); }});
}

}  // namespace rmpl::tools
