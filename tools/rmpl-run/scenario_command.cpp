// rmpl-run scenario: flies scenarios, tells their stories and judges them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "base/junit.hpp"
#include "base/limit_error.hpp"
#include "base/output_file.hpp"
#include "runtime/report/exports.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/flights.hpp"
#include "tools/rmpl-run/scenario_files.hpp"
#include "tools/rmpl-run/scenario_model.hpp"
#include "tools/rmpl-run/scenario_outcomes.hpp"
#include "tools/rmpl-run/scenario_table.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/report_file.hpp"
#include "tools/shared/stale_file.hpp"

namespace rmpl::tools {
namespace {

using runtime::TraceDetail;
using Engine = runtime::ScenarioOptions::Engine;
using Recovery = runtime::ScenarioOptions::Recovery;

constexpr const char* scenario_footer =
    R"(A scenario names a control program, a plant, what happens and what is expected.
Those of one file are told as stories while they fly, a line for each thing that changes; those of
several files as a table, with what was not met and why (-v tells their stories, too).

A file that is wrong takes nothing from the others: they are flown, and the exit code is 2.

exit code: 0 all expectations are met; 1 one failed; 2 an input is wrong; 3 interrupted: what was
found so far is told, and what was not flown

examples:
  rmpl-run scenario nominal.scn                    the story, and the verdicts
  rmpl-run scenario nominal.scn --follow           the flight on the terminal as it goes on
  rmpl-run scenario *.scn --junit out.xml          a table of verdicts, and a file for the CI
  rmpl-run scenario nominal.scn --report out.html  a page to look at it in a browser
  rmpl-run scenario nominal.scn --trace out.jsonl  what changes, as JSON Lines
  rmpl-run scenario faults.scn --only 'pde reset'  one scenario of several
  rmpl-run scenario dice.scn --seed 42             another draw of the same plant
  rmpl-run scenario leak.scn --monitors tank.mon   readings from samples of telemetry
  rmpl-run scenario landing.scn --only-component engine --from 4.5h --to 5h)";

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

std::vector<runtime::Flight> data_of(std::vector<std::optional<Flown>>& flights) {
  std::vector<runtime::Flight> result;
  for (std::optional<Flown>& flown : flights) {
    if (flown && flown->data) result.push_back(std::move(*flown->data));
  }
  return result;
}

/// What all flights have come to.
std::string coverage_of(const std::vector<std::optional<Flown>>& flights) {
  std::vector<runtime::CoverageItem> items;
  for (const std::optional<Flown>& flown : flights) {
    if (flown) runtime::add(items, flown->coverage);
  }
  return runtime::to_json(items);
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

/// The answer in the form that was asked for. Stories have been told by now, and in their quiet form, too.
void print_answer(const std::vector<ScenarioOutcome>& outcomes, const FlightOptions& options, const Common& common) {
  switch (common.format) {
    case Format::json:
      return print_json(to_json(outcomes));
    case Format::junit:
      return print_file(to_junit(outcomes));
    case Format::text:
      break;
  }
  const bool flown = std::all_of(outcomes.begin(), outcomes.end(), [](const auto& o) { return o.flown != nullptr; });
  if (options.files.size() == 1 && flown && (common.quiet || outcomes.size() == 1)) return;
  const bool stories = options.tells_stories(common);
  const TableDetail detail = common.quiet ? TableDetail::failures
                             : stories    ? TableDetail::verdicts
                                          : TableDetail::reasons;
  print((stories ? "\n" : "") + to_table(outcomes, detail, output_painter(common.color)));
}

/// --junit takes the place of a file before all inputs are read: it must be none that the command line names.
void check_junit(const FlightOptions& options) {
  std::vector<std::string> inputs = options.files;
  inputs.insert(inputs.end(), options.monitors.begin(), options.monitors.end());
  for (const std::string& file : inputs) {
    std::error_code unknown;  // one of them is not there
    if (options.junit.empty() || !std::filesystem::equivalent(file, options.junit, unknown)) continue;
    throw base::InputError(options.junit + ": writing there would destroy the input " + file);
  }
}

/// What went wrong before there was an answer, as the only case of --junit: the file of an earlier run goes.
void write_failure(const FlightOptions& options, const std::string& reason) {
  if (options.junit.empty()) return;
  constexpr const char* suite = "rmpl-run scenario";
  std::string files;
  for (const std::string& file : options.files) files += (files.empty() ? "" : " ") + file;
  try {
    base::write_file(options.junit, base::to_junit(suite, {base::no_answer(files, suite, reason)}));
  } catch (const base::InputError&) {
    // What went wrong first is what is told.
  }
}

ExitStatus fly_scenarios(const FlightOptions& options, const Common& common, const Settings& settings) {
  std::vector<std::string> inputs = options.files;
  inputs.insert(inputs.end(), options.monitors.begin(), options.monitors.end());
  check_standard_input(inputs);
  if (options.to < options.from) throw base::InputError("--to: expected a time that is not before --from");
  const std::vector<ScenarioFile> files =
      read_scenarios(options.files, ScenarioMonitors(options.monitors, settings.manifest), common);
  const std::vector<Task> tasks = tasks_of(files, options);
  std::optional<base::OutputFile> junit;
  if (!options.junit.empty()) junit.emplace(options.junit);  // a name that cannot be written is told at once
  Exports exports(options);
  std::optional<base::OutputFile> coverage;
  if (!options.coverage.empty()) coverage.emplace(options.coverage);
  std::optional<ReportFile> report;
  if (!options.report.empty()) report.emplace(options.report, models_of(tasks));
  std::vector<std::optional<Flown>> flights = fly_all(tasks, options, common);
  const std::vector<ScenarioOutcome> outcomes = outcomes_of(files, tasks, flights);
  print_answer(outcomes, options, common);
  if (junit) {
    junit->write(to_junit(outcomes));
    junit->keep();
  }
  if (coverage) {
    coverage->write(coverage_of(flights));
    coverage->keep();
  }
  const ExitStatus status = status_of(outcomes);
  if (!flights.empty() && flights.front()) {
    if (flights.front()->data) exports.write(*flights.front()->data);
  } else {
    for (const std::string& path : {options.trace, options.vcd, options.csv, options.mcap}) remove_stale(path);
  }
  if (report) report->write(title_of(options), data_of(flights), common.quiet);
  return status;
}

ExitStatus run(const FlightOptions& options, const Common& common, const Settings& settings) {
  if (!options.commands.empty()) return run_model(options, common);
  check_junit(options);
  try {
    return fly_scenarios(options, common, settings);
  } catch (const Rejected& rejected) {
    write_failure(options, rejected.text);
    throw;
  } catch (const base::InputError& error) {
    write_failure(options, error.what());
    throw;
  } catch (const base::LimitError& error) {
    write_failure(options, error.what());
    throw;
  }
}

/// With --commands nothing flies: of the options the seed alone has a meaning.
void exclude_flights(Command& command) {
  Option list = command.option("--commands");
  for (Option other : command.options()) {
    const bool general =
        other.is_positional() || other == list || other.is_called("--seed") || other.is_called("--help");
    if (!general) list.excludes(other);
  }
}

}  // namespace

void add_scenario(Program& program) {
  Command command = program.add_command("scenario", "fly a scenario: the executive on a simulated plant");
  const auto options = std::make_shared<FlightOptions>();
  command.add_option("FILE", options->files, "files of scenarios: .scn, or compiled .json").required();
  command.add_option("--only", options->only, "run this scenario only; may be given several times")
      .option_text("NAME")
      .repeatable();
  constexpr std::uint64_t most_jobs = 256;
  options->jobs = std::clamp(std::thread::hardware_concurrency(), 1u, static_cast<unsigned>(most_jobs));
  add_whole_number(command, "--jobs,-j", options->jobs, 1, most_jobs,
                   "how many scenarios fly at once; the output is the same for any number\n(default: one per core)");
  add_monitors(command, options->monitors);
  command.add_flag("--follow", options->follow, "show the flight live on the terminal instead of its story");
  command.add_option("--trace", options->trace, "write the trace as JSON Lines").option_text("OUT.jsonl");
  command.add_option("--report", options->report, "write a page to look at the flights in a browser, all in one file")
      .option_text("OUT.html");
  command.add_option("--vcd", options->vcd, "write a value change dump, for wave viewers").option_text("OUT.vcd");
  command.add_option("--csv", options->csv, "write all changes as a table").option_text("OUT.csv");
  command.add_option("--mcap", options->mcap, "write MCAP, for robotics tools").option_text("OUT.mcap");
  command.add_option("--junit", options->junit, "write a test case for each expectation, for continuous integration")
      .option_text("OUT.xml");
  command
      .add_option("--coverage", options->coverage,
                  "write which modes, transitions, faults and program locations the flights reached")
      .option_text("OUT.json");
  add_choice<TraceDetail>(
      command, "--trace-detail", options->detail,
      {{"changes", TraceDetail::changes}, {"cycles", TraceDetail::cycles}, {"beliefs", TraceDetail::beliefs}},
      "contents of the trace: cycles in which something changes, every cycle,\nor every cycle with all tracked states "
      "(default: changes)");
  add_whole_number(command, "--keyframe", options->keyframe, 1, 1'000'000'000,
                   "with the detail changes: every N-th line of the trace lists everything (default: 1000)");
  command
      .add_option("--only-component", options->components,
                  "tell only lines about this component; may be given several times")
      .option_text("NAME")
      .repeatable();
  add_read(command, "--from", options->from, duration, "tell the story from this time on").option_text("TIME");
  add_read(command, "--to", options->to, duration, "tell the story up to this time").option_text("TIME");
  add_whole_number(command, "--seed", options->seed, 0, std::numeric_limits<std::uint64_t>::max(),
                   "draw the plant with this seed instead of the scenario's");
  command
      .add_option("--commands", options->commands,
                  "simulate a model program under these commands, and print the run as a log; FILE is\nthen a .rmpl or "
                  ".tcca file; - is standard input")
      .option_text("IN.jsonl");
  add_format(command, program.common(), true);
  add_choice<Engine>(command, "--estimator", options->engine, {{"exact", Engine::exact}, {"k-best", Engine::k_best}},
                     "the estimator of the executive (default: k-best)");
  add_k(command, options->k);
  add_choice<Recovery>(command, "--reconfigurer", options->recovery,
                       {{"planner", Recovery::planner}, {"one-step", Recovery::one_step}},
                       "the method that finds commands (default: planner)");
  command.add_flag("--real-time", options->real_time, "run in real time");
  command.add_flag("--stats", options->stats,
                   "print on standard error how long cycles took: estimation, reconfiguration, both");
  exclude_flights(command);
  command.footer(scenario_footer);
  program.add({command,
               [options, &program] {
                 return within_limits([&] { return run(*options, program.common(), program.settings()); });
               },
               AtSignal::tell});
}

}  // namespace rmpl::tools
