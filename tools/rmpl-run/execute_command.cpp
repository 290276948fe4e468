// rmpl-run execute: the executive on a plant outside the process.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/journal_file.hpp"
#include "runtime/executive/live/run.hpp"
#include "runtime/executive/scenario/story.hpp"
#include "runtime/executive/trace/trace_writer.hpp"
#include "tools/rmpl-run/child_plant.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/follow.hpp"
#include "tools/rmpl-run/foxglove_watch.hpp"
#include "tools/rmpl-run/listening_plant.hpp"
#include "tools/rmpl-run/log_options.hpp"
#include "tools/rmpl-run/view_keeper.hpp"
#include "tools/rmpl-run/views.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

using runtime::LiveResult;
using runtime::ScenarioOptions;
using runtime::TraceDetail;
using LiveTime = runtime::LiveOptions::Time;

struct ExecuteOptions {
  std::string program;
  std::string plant;
  std::string main;
  std::string command;
  std::string address;
  std::string token;
  std::string monitors;
  bool remote = false;
  std::string trace;
  ViewPaths views;
  bool follow = false;
  std::optional<std::string> foxglove;
  bool foxglove_remote = false;
  TraceDetail detail = TraceDetail::changes;
  std::uint64_t keyframe = runtime::TraceWriter::usual_keyframe;
  runtime::LiveRun run;
};

constexpr const char* execute_footer =
    R"(Each cycle the plant gets one line, {"cycle":7,"time":3,"until":3.5,"command":{…}}, and answers with
one, {"cycle":7,"observations":{…}}, before the cycle is over. What it does not say is not observed.
docs/execute.md has the whole protocol, and what becomes of a plant that is late, dead or mad.

The trace and the views are written as the flight goes on: whatever ends it, they are there up to the last
cycle.

exit code: 0 the program ended, or the duration was over; 2 an input is wrong; 3 interrupted, or no
plant was there for too long

examples:
  rmpl-run execute entry.rmpl lander.tcca --exec './simulator.py --seed 1'
  rmpl-run execute entry.rmpl lander.tcca --listen unix:/run/lander.sock --trace flight.jsonl
  rmpl-run execute entry.rmpl lander.tcca --exec ./simulator.py --clock lock-step --report flight.html
  rmpl-run execute entry.rmpl lander.tcca --exec ./simulator.py --foxglove 8765)";

/// The first line of the file; without it nobody is let in.
std::string read_token(const std::string& path) {
  std::string token = base::read_file(path);
  token.resize(std::min(token.find_first_of("\r\n"), token.size()));
  constexpr std::size_t least = 16, most = 4096;
  if (token.size() < least || token.size() > most) {
    throw base::InputError("--token: " + path + ": expected a first line of 16 to 4096 bytes");
  }
  return token;
}

std::unique_ptr<runtime::Channel> make_channel(const ExecuteOptions& options) {
  if (!options.command.empty()) return std::make_unique<ChildPlant>(options.command, interrupted);
  if (options.remote && options.token.empty()) {
    throw base::InputError("--allow-remote requires --token: otherwise anybody could connect");
  }
  const std::string token = options.token.empty() ? "" : read_token(options.token);
  auto channel = std::make_unique<ListeningPlant>(options.address, options.remote, token, interrupted);
  tell("waiting for a plant at " + channel->address());
  channel->await_first(options.run.give_up);
  return channel;
}

ExitStatus status_of(LiveResult::End end) {
  switch (end) {
    case LiveResult::End::program:
    case LiveResult::End::duration:
      return ExitStatus::done;
    case LiveResult::End::interrupted:
    case LiveResult::End::abandoned:
      return ExitStatus::undecided;
  }
  return ExitStatus::undecided;
}

ExitStatus run(const ExecuteOptions& options, const Common& common) {
  const compiler::Compilation compilation =
      load({options.program, options.plant}, common, {.main = options.main, .model_is_plant = true});
  const automata::Document& document = compilation.document();
  const automata::Program& program = only_program(document, options.program);
  const automata::Plant& plant = only_plant(document, options.plant);
  automata::Scenario flown;  // for those who look on
  flown.name = program.name;
  flown.cycle = options.run.cycle;
  flown.duration = options.run.duration;
  std::vector<runtime::CycleObserver*> observers;
  std::optional<ViewKeeper> keeper;
  if (options.views.any()) observers.push_back(&keeper.emplace(document, flown, options.views, common.quiet));
  std::optional<base::JournalFile> journal;
  std::optional<runtime::TraceWriter> trace;
  if (!options.trace.empty()) {
    journal.emplace(options.trace);
    const auto write = [&journal](std::string_view line) { journal->append(line); };
    observers.push_back(&trace.emplace(plant, program, write, options.detail, options.keyframe));
  }
  const bool exact = options.run.plant.time == LiveTime::lock_step;
  constexpr automata::Ticks day = automata::Ticks::of_seconds(24L * 3600);
  const runtime::MomentColumn column(std::min(options.run.duration, day),
                                     exact ? options.run.cycle : automata::Ticks{1});
  const base::Painter painter = output_painter(common.color);
  runtime::Story story(plant, program, column, painter, {}, [](const std::string& line) { print(line + "\n"); });
  // Behind the process that keeps the views: it starts a thread.
  std::optional<FoxgloveWatch> watch;
  if (options.foxglove) {
    observers.push_back(&watch.emplace(document, flown, *options.foxglove, options.foxglove_remote, common.quiet));
  }
  const bool for_programs = common.format == Format::json;
  const bool followed = options.follow && !common.quiet && !for_programs && output_is_seen();
  std::optional<FollowScreen> screen;
  if (followed) observers.push_back(&screen.emplace(plant, program, flown, painter));
  if (!followed && !common.quiet && !for_programs) observers.push_back(&story);

  runtime::LiveRun live = options.run;
  live.plant.interrupted = interrupted;
  if (!options.monitors.empty()) live.plant.monitors = load_monitors(options.monitors, plant, common);
  const auto channel = make_channel(options);
  LiveResult result;
  if (options.address.empty() || channel->connected()) {
    runtime::Engines engines(plant, live.engines, live.cycle);
    result = runtime::run_live(program, engines, *channel, live, observers);
    if (screen) screen->finish();
    if (trace) trace->keep();
  } else {
    result.end = interrupted() ? LiveResult::End::interrupted : LiveResult::End::abandoned;
  }
  const std::string summary = runtime::summary(result, live.give_up);
  if (watch) watch->finish(summary);
  if (keeper) keeper->finish(summary, result.end == LiveResult::End::program);
  for_programs ? print_json(runtime::to_json(result)) : print(summary);
  return status_of(result.end);
}

}  // namespace

void add_engines(Command& command, ScenarioOptions& engines) {
  add_choice<ScenarioOptions::Engine>(
      command, "--estimator", engines.engine,
      {{"exact", ScenarioOptions::Engine::exact}, {"k-best", ScenarioOptions::Engine::k_best}},
      "the estimator of the executive (default: k-best)");
  add_k(command, engines.k);
  add_choice<ScenarioOptions::Recovery>(
      command, "--reconfigurer", engines.recovery,
      {{"planner", ScenarioOptions::Recovery::planner}, {"one-step", ScenarioOptions::Recovery::one_step}},
      "the method that finds commands (default: planner)");
}

void add_execute(Program& program) {
  Command command = program.add_command("execute", "run a control program on a plant outside the process");
  const auto options = std::make_shared<ExecuteOptions>();
  command.add_option("PROGRAM", options->program, "a .rmpl control program, or a compiled .json").required();
  command.add_option("PLANT", options->plant, "a plant model: .tcca, or a compiled .json").required();
  Option exec =
      command.add_option("--exec", options->command, "the plant is this command of the shell").option_text("COMMAND");
  Option listen = command.add_option("--listen", options->address, "the plant connects to unix:PATH or tcp:HOST:PORT")
                      .option_text("ADDRESS");
  command.require_one(exec, listen);
  command.add_option("--token", options->token, "accept only a plant that first sends the first line of this file")
      .option_text("FILE")
      .needs(listen);
  command.add_flag("--allow-remote", options->remote, "accept connections from other machines; requires --token")
      .needs(listen);
  command
      .add_option("--monitors", options->monitors, "monitors that turn numbers and texts from the plant into readings")
      .option_text("FILE.mon");
  add_read(command, "--cycle", options->run.cycle, positive_duration, "length of a cycle (default: 0.5 s)")
      .option_text("TIME");
  add_choice<LiveTime>(command, "--clock", options->run.plant.time,
                       {{"wall", LiveTime::wall}, {"lock-step", LiveTime::lock_step}},
                       "a cycle takes real time, or ends when the plant answers,\nwith simulated time (default: wall)");
  add_read(command, "--patience", options->run.plant.patience, positive_duration,
           "with lock-step: how long to wait for an answer (default: 10 s)")
      .option_text("TIME");
  add_read(command, "--duration", options->run.duration, positive_duration, "end after this time").option_text("TIME");
  add_read(command, "--give-up", options->run.give_up, positive_duration,
           "end if no plant is connected for this time (default: 60 s)")
      .option_text("TIME");
  command.add_option("--trace", options->trace, "write the trace as JSON Lines").option_text("OUT.jsonl");
  add_views(command, options->views);
  const auto as_given = [](const std::string& text) { return text; };
  Option foxglove =
      add_read(command, "--foxglove", options->foxglove, as_given, "let Foxglove watch the flight at this local port")
          .option_text("[HOST:]PORT");
  command.add_flag("--foxglove-remote", options->foxglove_remote, "let Foxglove on other machines watch, too")
      .needs(foxglove);
  command.add_flag("--follow", options->follow, "show the flight live on the terminal instead of its story");
  add_choice<TraceDetail>(
      command, "--trace-detail", options->detail,
      {{"changes", TraceDetail::changes}, {"cycles", TraceDetail::cycles}, {"beliefs", TraceDetail::beliefs}},
      "contents of the trace: cycles in which something changes, every cycle,\nor every cycle with all tracked states "
      "(default: changes)");
  add_whole_number(command, "--keyframe", options->keyframe, 1, 1'000'000'000,
                   "with the detail changes: every N-th line of the trace lists everything (default: 1000)");
  add_engines(command, options->run.engines);
  add_format(command, program.common());
  command
      .add_option("--main", options->main, "the definition to run, if there are several that no other definition calls")
      .option_text("NAME");
  command.footer(execute_footer);
  program.add({command,
               [options, &common = program.common()] { return within_limits([&] { return run(*options, common); }); },
               AtSignal::tell});
}

}  // namespace rmpl::tools
