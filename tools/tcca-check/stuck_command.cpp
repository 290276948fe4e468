// tcca-check stuck.
// SPDX-License-Identifier: MIT
#include <memory>

#include "tools/tcca-check/commands.hpp"
#include "tools/tcca-check/property_check.hpp"

namespace rmpl::tools {

void add_stuck(Program& program) {
  CLI::App* command = program.app().add_subcommand(
      "stuck", "can something follow wherever the plant comes, and does time pass? no: the way there");
  const auto options = std::make_shared<PropertyOptions>();
  add_property_options(*command, *options, program.common(), Asked::dead_end);
  program.add({command, [options, &common = program.common()] {
                 return check_property(*options, common, "stuck",
                                       [](const automata::Plant&) { return verifier::Stuck{}; });
               }});
}

}  // namespace rmpl::tools
