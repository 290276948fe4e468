// rmplc new: a project to begin with.
// SPDX-License-Identifier: MIT
#include <memory>

#include "tools/rmplc/commands.hpp"
#include "tools/rmplc/project/new_project.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

constexpr const char* new_notes =
    R"(Makes a folder with rmpl.toml, a plant, a program, scenarios and properties, which
compile, fly and hold. A folder or file of that name must not be there; where the
project cannot be made whole, nothing of it stays.

Exit status: 0 the project is there, 2 it could not be made.

Example:
  rmplc new demo && cd demo && rmplc test)";

}  // namespace

void add_new(Program& program) {
  Command command = program.add_command("new", "create a new project");
  const auto folder = std::make_shared<std::string>();
  command.add_option("NAME", *folder, "the folder; its name is the name of the project").required();
  command.footer(new_notes);
  program.add({command, [folder, &common = program.common()] {
                 make_project(*folder);
                 if (!common.quiet) print(*folder + ": created; `rmplc test " + *folder + "` tests it\n");
                 return ExitStatus::done;
               }});
}

}  // namespace rmpl::tools
