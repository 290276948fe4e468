// rmpl-run step: a run cycle by cycle, forth and back, with what may come to choose from.
// SPDX-License-Identifier: MIT
#include <limits>
#include <memory>
#include <string>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "tools/rmpl-run/commands.hpp"
#include "tools/rmpl-run/debug_adapter.hpp"
#include "tools/rmpl-run/prompt.hpp"
#include "tools/rmpl-run/scenario_monitors.hpp"
#include "tools/rmpl-run/step_model.hpp"
#include "tools/rmpl-run/step_session.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"

namespace rmpl::tools {
namespace {

constexpr const char* step_footer =
    R"(Shows where the run stands, and what may come: commands, transitions with their time windows, faults,
each with a number to choose it by. An empty line goes on by one cycle; `help` lists the commands.
On a terminal lines are edited; otherwise they are read from standard input, as a script, and a wrong
command ends the run.

exit code: 0 quit, or the end of the input; 1 an editor that debugged is gone without a word; 2 an input
or, from a script, a command is wrong: what came before it is done; 3 interrupted

examples:
  rmpl-run step entry.rmpl lander.tcca               the program, on a plant that is drawn from the model
  rmpl-run step lander.tcca                          the plant alone: commands and goals by hand
  rmpl-run step faults.scn --only 'pde reset'        a scenario
  rmpl-run step entry.rmpl lander.tcca --trace f.jsonl   a trace, or a witness of tcca-check --format json
  echo 'until surprise' | rmpl-run step entry.rmpl lander.tcca)";

/// One command after the other. A script shows each, so that its output reads as a session does.
ExitStatus converse(StepSession& session, const Common& common) {
  Prompt prompt([&] { return session.words(); });
  const base::Painter painter = output_painter(common.color);
  session.greet();
  while (const auto line = prompt.next()) {
    if (!prompt.is_terminal()) print(painter.strong(prompt_text) + *line + "\n");
    try {
      if (!session.obey(*line)) return ExitStatus::done;
    } catch (const base::InputError& error) {
      if (!prompt.is_terminal()) throw;
      tell(error.what());
    } catch (const Rejected&) {
      if (!prompt.is_terminal()) throw;
    }
    if (interrupted()) break;
  }
  return interrupted() ? ExitStatus::undecided : ExitStatus::done;
}

ExitStatus run(StepOptions options, bool debugger, const Common& common, const Settings& settings) {
  if (debugger) return serve_debugger(options.engines, common);
  if (options.files.empty()) throw base::InputError("expected PROGRAM PLANT, PLANT, or a file of scenarios");
  if (options.files.size() == 1)
    options.monitors = ScenarioMonitors(options.monitors, settings.manifest).of(options.files.front());
  StepModel model(options, common);
  const std::string trace = options.trace.empty() ? "" : base::read_file(options.trace);
  StepSession session(model, trace, options.trace, common);
  return converse(session, common);
}

}  // namespace

void add_step(Program& program) {
  Command command = program.add_command("step", "step through a run, forward and backward");
  const auto options = std::make_shared<StepOptions>();
  const Option files =
      command.add_option("FILES", options->files, "PROGRAM PLANT, PLANT alone, or a file of scenarios (.scn)");
  const auto debugger = std::make_shared<bool>(false);
  const Option only = command.add_option("--only", options->only, "the scenario of this name, where a file has several")
                          .option_text("NAME");
  Option dap = command.add_flag("--dap", *debugger,
                                "serve the debugger of an editor on standard input; the editor names the files");
  const Option trace = command
                           .add_option("--trace", options->trace,
                                       "step through this trace, or this witness of tcca-check, instead of a new run")
                           .option_text("FILE");
  const Option cycle =
      add_read(command, "--cycle", options->cycle, positive_duration, "length of a cycle (default: 0.5 s)")
          .option_text("TIME")
          .excludes(trace);
  const Option duration =
      add_read(command, "--duration", options->duration, positive_duration, "the end of the run (default: 24 h)")
          .option_text("TIME")
          .excludes(trace);
  const Option seed = add_whole_number(command, "--seed", options->seed, 0, std::numeric_limits<std::uint64_t>::max(),
                                       "draw the plant with this seed (default: 0, or the scenario's)")
                          .excludes(trace);
  add_engines(command, options->engines);
  for (const char* name : {"--estimator", "-k", "--reconfigurer"}) command.option(name).excludes(trace);
  const Option main = command
                          .add_option("--main", options->main,
                                      "the definition to run, if there are several that no other definition calls")
                          .option_text("NAME");
  add_monitors(command, options->monitors);
  const Option monitors = command.option("--monitors");
  for (const Option& said : {files, only, monitors, trace, cycle, duration, seed, main}) dap.excludes(said);
  command.footer(step_footer);
  program.add({command,
               [options, debugger, &program] {
                 return within_limits([&] { return run(*options, *debugger, program.common(), program.settings()); });
               },
               AtSignal::tell});
}

}  // namespace rmpl::tools
