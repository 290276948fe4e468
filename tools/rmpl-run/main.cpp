// rmpl-run: runs timed model-based programs, and the parts of the executive one by one.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/commands.hpp"

namespace {

constexpr const char* main_notes =
    R"(Times are seconds, or have a unit: 30, 30 s, 270 min, 4.5 h. '-' is standard input.
Every subcommand has its own --help, with examples.

exit code: 0 done, expectations met; 1 an expectation failed, or no plan; 2 the command line or an
input is wrong, and nothing was written; 3 undecided: interrupted, or a limit was hit; 4 an internal
error, and nothing is claimed)";

}  // namespace

int main(int count, char** arguments) {
  using namespace rmpl::tools;
  Program program("rmpl-run", RMPL_VERSION,
                  "Runs timed model-based programs: the executive on a simulated plant, and its parts one by one.",
                  main_notes);
  add_scenario(program);
  add_step(program);
  add_execute(program);
  add_campaign(program);
  add_report(program);
  add_estimate(program);
  add_sequence(program);
  add_plan(program);
  add_diagnose(program);
  return program.run(count, arguments);
}
