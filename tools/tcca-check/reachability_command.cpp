// tcca-check reachability.
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
  const FormulaAsked asked{verifier::MarkingQuestion::Kind::reachability, options.formula, "--target", options.window};
  return check_property(
      options, common, "reachability " + options.formula,
      [&](const automata::Plant& plant) {
        return verifier::Reachability{formula_option(options.formula, plant, "--target", common), options.window,
                                      options.fastest};
      },
      &asked);
}

}  // namespace

void add_reachability(Program& program) {
  CLI::App* command = program.app().add_subcommand(
      "reachability", "can the plant reach a state in which a formula holds? yes: a timed witness");
  const auto options = std::make_shared<Options>();
  add_text(*command, "--target", options->formula, "FORMULA", "what is to be reached")->required();
  add_window(*command, *options);
  add_property_options(*command, *options, program.common());
  command->footer(std::string(model_notes) + "\n\n" + command->get_footer());
  program.add({command, [options, &common = program.common()] { return run(*options, common); }});
}

}  // namespace rmpl::tools
