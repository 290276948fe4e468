// A subcommand for a formula and the times at which it counts.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/formula_check.hpp"

#include <memory>
#include <string>

#include "tools/shared/models.hpp"
#include "tools/tcca-check/property_check.hpp"

namespace rmpl::tools {
namespace {

constexpr const char* model_notes =
    R"(MODEL may be a model program (.rmpl): its threads are the components of the plant, which takes steps of a second, or
of --time T. Any number of faults is allowed it, unless --faults is given.)";

struct FormulaCheckOptions : PropertyOptions, WindowOptions {
  std::string formula;
};

ExitStatus run(const FormulaCheck& check, const FormulaCheckOptions& options, const Common& common) {
  return check_property(options, common, std::string(check.name) + " " + options.formula,
                        [&](const automata::Plant& plant) -> verifier::Property {
                          check_window(options.window, period_of(options.freedom, plant));
                          auto formula = formula_option(options.formula, plant, check.option, common);
                          if (check.never) return verifier::Safety{std::move(formula), options.window, options.fastest};
                          return verifier::Reachability{std::move(formula), options.window, options.fastest};
                        });
}

}  // namespace

void add_formula_check(Program& program, const FormulaCheck& check) {
  Command command = program.add_command(check.name, check.description);
  const auto options = std::make_shared<FormulaCheckOptions>();
  add_text(command, check.option, options->formula, "FORMULA", check.meaning).required();
  add_window(command, *options);
  add_property_options(command, *options, program.common());
  command.prepend_footer(model_notes);
  program.add(
      {command, [check, options, &common = program.common()] { return run(check, *options, common); }, AtSignal::tell});
}

}  // namespace rmpl::tools
