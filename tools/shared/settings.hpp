// rmpl.ini: what the programs take for granted where the command line says nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "automata/time/time.hpp"
#include "compiler/lint/lint.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::tools {

/// What a file of settings says. The texts of common options are as on the command line.
struct Settings {
  std::string path;                            ///< empty: there is no file
  std::map<std::string, std::string> options;  ///< of those in common, without dashes: `color`, `quiet`, …
  compiler::LintSettings lint;
  std::optional<grammar::Severity> level;  ///< the least that counts
};

/// Reads the nearest `rmpl.ini` in the folder of a file (of a name that is empty or `-`: where the program runs) and
/// the folders above it. Throws base::InputError where it cannot be read, or a key or value of it is not known.
Settings find_settings(const std::string& first_file);

/// Reads one. `text` is what the file at `path` holds.
Settings read_settings(const std::string& path, const std::string& text);

}  // namespace rmpl::tools
