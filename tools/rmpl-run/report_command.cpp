// rmpl-run report: any view of a trace.
// SPDX-License-Identifier: MIT
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "runtime/executive/scenario/moment.hpp"
#include "runtime/executive/scenario/story.hpp"
#include "runtime/executive/trace/trace_reader.hpp"
#include "runtime/report/recorder.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/log_options.hpp"
#include "tools/rmpl-run/named_model.hpp"
#include "tools/rmpl-run/trace_constraint.hpp"
#include "tools/rmpl-run/views.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

struct ReportOptions {
  std::string trace;
  std::vector<std::string> models;
  std::string main;
  std::string monitors;
  ViewPaths views;
};

constexpr const char* report_footer =
    R"(Tells the story of a trace, as of rmpl-run scenario or execute, and writes the views that are asked for,
the same as those of the flight itself: of a trace with the detail beliefs to the byte, but for what the
scenario expected; of the others without the belief. A trace that was cut off in a line, as by a crash, is
told up to the line before.

PROGRAM and PLANT are the models that flew. Without them there are the names of the trace alone: no drawings,
no places, no words of the program.

exit code: 0 done; 2 an input is wrong: nothing was written

examples:
  rmpl-run report flight.jsonl burn.rmpl propulsion.tcca
  rmpl-run report flight.jsonl burn.rmpl propulsion.tcca -q --report flight.html --mcap flight.mcap
  rmpl-run report flight.jsonl --csv flight.csv)";

/// What flew, and as which scenario: of no account but for the name and the length of a cycle.
struct ReportedFlight {
  automata::Document document;
  automata::Scenario scenario;
};

ReportedFlight models_of(const ReportOptions& options, const std::string& text, const Common& common) {
  ReportedFlight flown;
  if (options.models.empty()) {
    auto named = named_model(text, options.trace);
    flown.document.plants.push_back(std::move(named.plant));
    flown.document.programs.push_back(std::move(named.program));
  } else {
    if (options.models.size() != 2) throw base::InputError("report: expected PROGRAM and PLANT, or neither");
    const compiler::Compilation compilation =
        load(options.models, common, {.main = options.main, .model_is_plant = true});
    flown.document = compilation.document();
    only_program(flown.document, options.models.front());
    only_plant(flown.document, options.models.back());
  }
  flown.scenario.name = options.trace.substr(options.trace.rfind('/') + 1);
  flown.scenario.cycle = {};
  return flown;
}

/// The records of a text, one by one. The last one that there was, if any.
template <class Look>
std::optional<runtime::CycleRecord> read(const ReportedFlight& flown, const std::string& text, const std::string& name,
                                         const Look& look) {
  const automata::Plant& plant = flown.document.plant_of(flown.scenario);
  std::istringstream in(text);
  runtime::TraceReader reader(in, name, plant, flown.document.programs.front(), trace_constraint(plant));
  if (!flown.scenario.monitors.empty()) reader.know(flown.scenario.monitors);
  std::optional<runtime::CycleRecord> last;
  while (const runtime::CycleRecord* record = reader.next()) {
    look(*record);
    last = *record;
  }
  return last;
}

ExitStatus run(const ReportOptions& options, const Common& common) {
  check_standard_input({options.trace});
  const std::string text = base::read_file(options.trace);
  ReportedFlight flown = models_of(options, text, common);
  const automata::Plant& plant = flown.document.plant_of(flown.scenario);
  const automata::Program& program = flown.document.programs.front();
  if (!options.monitors.empty()) flown.scenario.monitors = load_monitors(options.monitors, plant, common);
  // All of it is right, and how long it is, before anything is told.
  std::uint64_t lines = 0;
  const auto last = read(flown, text, options.trace, [&](const runtime::CycleRecord& record) {
    if (lines++ > 0) flown.scenario.cycle = record.time - record.start;
  });
  if (!last) throw base::InputError(options.trace + ": expected a trace, but the file has none");
  std::optional<Views> views;
  if (options.views.any()) views.emplace(options.views, plant, program);

  runtime::Recorder recorder(flown.document, flown.scenario);
  const runtime::MomentColumn column(last->time, flown.scenario.cycle);
  runtime::Story story(plant, program, column, output_painter(common.color), {},
                       [](const std::string& line) { print(line + "\n"); });
  read(flown, text, options.trace, [&](const runtime::CycleRecord& record) {
    recorder.observe(record);
    if (!common.quiet) story.observe(record);
  });
  if (!views) return ExitStatus::done;
  runtime::ScenarioResult result;
  result.cycles = last->cycle;
  result.time = last->time;
  runtime::Flight flight = recorder.finish(result);
  flight.verdict.clear();
  flight.seed.reset();
  flight.summary = "up to " + runtime::moment(result.time);
  views->write(flight, common.quiet);
  return ExitStatus::done;
}

}  // namespace

void add_report(Program& program) {
  Command command = program.add_command("report", "tell the story of a trace, and write any view of it");
  const auto options = std::make_shared<ReportOptions>();
  command.add_option("TRACE", options->trace, "a trace of a flight; - is standard input").required();
  command.add_option("MODELS", options->models, "PROGRAM and PLANT: the models of the flight");
  command
      .add_option("--monitors", options->monitors,
                  "monitors that read the channels of the trace: their limits appear in the views")
      .option_text("FILE.mon");
  add_views(command, options->views);
  command
      .add_option("--main", options->main,
                  "the definition that ran, if there are several that no other definition calls")
      .option_text("NAME");
  command.footer(report_footer);
  program.add({command, [options, &common = program.common()] { return run(*options, common); }});
}

}  // namespace rmpl::tools
