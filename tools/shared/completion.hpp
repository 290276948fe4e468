// Completions for shells, written from the options of a program.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace rmpl::tools {

/// A script for `bash`, `zsh` or `fish` that completes the subcommands and options of the program, the words that an
/// option takes, and names of files. Throws base::InputError for another shell.
std::string completion(const CLI::App& app, std::string_view shell);

}  // namespace rmpl::tools
