// tcca-check stuck.
// SPDX-License-Identifier: MIT
#include <memory>

#include "tools/tcca-check/commands.hpp"
#include "tools/tcca-check/property_check.hpp"

namespace rmpl::tools {

void add_stuck(Program& program) {
  Command command = program.add_command("stuck", "look for deadlocks and timelocks");
  const auto options = std::make_shared<PropertyOptions>();
  add_property_options(command, *options, program.common(), Asked::dead_end);
  program.add({command,
               [options, &common = program.common()] {
                 return check_property(*options, common, "stuck",
                                       [](const automata::Plant&) { return verifier::Stuck{}; });
               },
               AtSignal::tell});
}

}  // namespace rmpl::tools
