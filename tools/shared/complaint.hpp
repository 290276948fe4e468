// What the user of a wrong command line is told, by all programs alike.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace rmpl::tools {

/// `program: what is wrong`, and a line that says where help is. A subcommand or an option that there is not is named,
/// with the nearest one that there is. `error` is what parsing the command line of `app` threw, and no call for help.
std::string complaint(const CLI::App& app, const CLI::ParseError& error);

}  // namespace rmpl::tools
