// The subcommands of rmpl-run: each adds itself to the program, with its options.
// SPDX-License-Identifier: MIT
#pragma once

#include "base/limit_error.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "tools/shared/program.hpp"

namespace rmpl::runtime {
struct ScenarioOptions;
}

namespace rmpl::tools {

void add_scenario(Program& program);
void add_step(Program& program);
void add_execute(Program& program);
void add_campaign(Program& program);
void add_report(Program& program);
void add_estimate(Program& program);
void add_sequence(Program& program);
void add_plan(Program& program);
void add_diagnose(Program& program);

/// The plant, which may be a model program, and the definition that such a one starts with.
inline void add_plant(Command& command, std::string& plant, std::string& main) {
  command.add_option("PLANT", plant, "a .tcca model, an .rmpl file with a model program, or a compiled .json")
      .required();
  command
      .add_option("--main", main,
                  "the definition that a model program starts with, if there are several that no other calls")
      .option_text("NAME");
}

/// `-k N` of an estimator.
template <class Count>
void add_k(Command& command, Count& k) {
  constexpr std::uint64_t most = 1'000'000;
  add_whole_number(command, "-k", k, 1, most, "how many states k-best keeps (default: 16)");
}

/// How the executive estimates, and finds commands.
void add_engines(Command& command, runtime::ScenarioOptions& engines);

/// Runs what may need more states than there is room for: that is a limit like any other.
template <class Run>
ExitStatus within_limits(const Run& run) {
  try {
    return run();
  } catch (const runtime::TooManyStates& error) {
    throw base::LimitError(error.what());
  } catch (const runtime::Interrupted& error) {
    throw base::LimitError(error.what());
  }
}

}  // namespace rmpl::tools
