// tcca-check safety.
// SPDX-License-Identifier: MIT
#include <memory>

#include "tools/shared/models.hpp"
#include "tools/tcca-check/commands.hpp"
#include "tools/tcca-check/model_check.hpp"
#include "tools/tcca-check/property_check.hpp"

namespace rmpl::tools {
namespace {

struct Options : PropertyOptions, WindowOptions {
  std::string formula;
};

ExitStatus run(const Options& options, const Common& common) {
  const FormulaAsked asked{verifier::MarkingQuestion::Kind::safety, options.formula, "--never", options.window};
  return check_property(
      options, common, "safety " + options.formula,
      [&](const automata::Plant& plant) {
        return verifier::Safety{formula_option(options.formula, plant, "--never", common), options.window,
                                options.fastest};
      },
      &asked);
}

}  // namespace

void add_safety(Program& program) {
  CLI::App* command = program.app().add_subcommand("safety", "does a formula never hold? no: a timed counterexample");
  const auto options = std::make_shared<Options>();
  add_text(*command, "--never", options->formula, "FORMULA", "what is never to hold")->required();
  add_window(*command, *options);
  add_property_options(*command, *options, program.common());
  command->footer(std::string(model_notes) + "\n\n" + command->get_footer());
  program.add({command, [options, &common = program.common()] { return run(*options, common); }});
}

}  // namespace rmpl::tools
