// tcca-check response.
// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>

#include "base/error.hpp"
#include "tools/shared/models.hpp"
#include "tools/tcca-check/commands.hpp"
#include "tools/tcca-check/property_check.hpp"
#include "tools/tcca-check/timed_formula.hpp"

namespace rmpl::tools {
namespace {

struct ResponseOptions : PropertyOptions {
  TimedResponse response;
  std::optional<TimedFormula> within;
};

ExitStatus run(const ResponseOptions& options, const Common& common) {
  TimedResponse response = options.response;
  if (options.within) {
    if (response.then.time) throw base::InputError("--within: --after already has its own time");
    response.then = *options.within;
  }
  if (!response.then.time || response.then.formula.empty()) {
    const std::string given = response.then.formula.empty() ? "" : ", not '" + response.then.formula + "'";
    throw base::InputError("--within: expected a time and a formula, as in '5 s x = y' or 'inf x = y'" + given);
  }
  const automata::Ticks time = *response.then.time;
  if (options.cut_sets && time.is_infinite()) throw base::InputError(no_cut_sets_of_some_day);
  const std::string within = automata::format_seconds(time) + (time.is_infinite() ? "" : " s");
  const std::string title = "response " + response.asks + " within " + within + " " + response.then.formula;
  return check_property(options, common, title, [&](const automata::Plant& plant) {
    return verifier::Response{formula_option(response.asks, plant, "--after", common),
                              formula_option(response.then.formula, plant, "--within", common), time};
  });
}

}  // namespace

void add_response(Program& program) {
  Command command = program.add_command(
      "response", "does a response always follow a trigger in time? if not, print a timed counterexample");
  const auto options = std::make_shared<ResponseOptions>();
  add_read(command, "--after", options->response, timed_response, "the trigger: a formula")
      .option_text("FORMULA")
      .required();
  add_read(command, "--within", options->within, timed_formula, "the time limit and the response; inf: no limit")
      .option_text("T FORMULA");
  add_property_options(command, *options, program.common());
  program.add({command, [options, &common = program.common()] { return run(*options, common); }, AtSignal::tell});
}

}  // namespace rmpl::tools
