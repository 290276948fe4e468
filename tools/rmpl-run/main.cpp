// rmpl-run: runs timed model-based programs, and the parts of the executive one by one.
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/out_of_memory.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "tools/rmpl-run/command.hpp"
#include "tools/shared/complaint.hpp"

using namespace rmpl;

namespace {

using runtime::Color;
using runtime::Common;
using runtime::Status;
using runtime::Subcommand;

constexpr const char* footer = R"(Times are seconds, or have a unit: 30, 30 s, 270 min, 4.5 h. '-' is standard input.
Every subcommand has its own --help, with examples.

exit code: 0 done, expectations met; 1 an expectation failed, or no plan; 2 the command line or an
input is wrong, and nothing was written; 3 undecided: interrupted, or a limit was hit)";

void add_common(CLI::App& app, Common& common) {
  app.set_version_flag("--version", "rmpl-run " RMPL_VERSION);
  runtime::add_choice<Color>(app, "--color", common.color,
                             {{"auto", Color::automatic}, {"always", Color::always}, {"never", Color::never}},
                             "colours: auto on a terminal, always or never (default: auto)");
  app.add_flag("-q", common.quiet, "say less: no story, no warnings");
  app.add_flag("-v", common.verbose, "say more: statistics on standard error");
}

}  // namespace

int main(int argc, char** argv) {
  std::set_terminate([] { base::end_for_lack_of_memory("rmpl-run"); });
  CLI::App app("Runs timed model-based programs: the executive on a simulated plant, and its parts one by one.",
               "rmpl-run");
  Common common;
  add_common(app, common);
  app.require_subcommand(1);
  app.fallthrough();
  app.footer(footer);
  const std::vector<Subcommand> commands{runtime::scenario_command(app, common), runtime::estimate_command(app, common),
                                         runtime::sequence_command(app, common), runtime::plan_command(app, common),
                                         runtime::diagnose_command(app, common)};
  try {
    app.parse(argc, argv);
    for (const Subcommand& command : commands) {
      if (command.app->parsed()) return static_cast<int>(command.run());
    }
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // help or version
      app.exit(error);
      return static_cast<int>(std::cout.flush() ? Status::done : Status::wrong);
    }
    std::cerr << automata::complaint(app, error);
    return static_cast<int>(Status::wrong);
  } catch (const base::InputError& error) {
    std::cerr << "rmpl-run: " << error.what() << '\n';
    return static_cast<int>(Status::wrong);
  } catch (const runtime::TooManyStates& error) {
    std::cerr << "rmpl-run: " << error.what() << '\n';
    return static_cast<int>(Status::undecided);
  } catch (const base::InternalError& error) {
    std::cerr << "rmpl-run: internal error, nothing is claimed: " << error.what() << '\n';
    return 4;
  } catch (const std::bad_alloc&) {
    std::cerr << "rmpl-run: out of memory\n";
    return static_cast<int>(Status::undecided);
  }
  return static_cast<int>(Status::done);
}
