// What the programs take for granted where the command line says nothing: rmpl.ini over rmpl.toml.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "compiler/lint_codes/lint_codes.hpp"
#include "grammar/source/diagnostic.hpp"
#include "tools/shared/lint_levels.hpp"
#include "tools/shared/manifest.hpp"

namespace rmpl::tools {

/// What the files of settings say. The texts of common options are as on the command line.
struct Settings {
  std::string path = {};                            ///< of rmpl.ini; empty: there is none
  std::map<std::string, std::string> options = {};  ///< of those in common, without dashes: `color`, `quiet`, …
  compiler::LintSettings lint = {};
  std::optional<grammar::Severity> level = {};  ///< the least that counts
  std::optional<Manifest> manifest = {};        ///< of the project that the file belongs to
};

/// The nearest `rmpl.toml` in the folder of a file (in a folder itself; of a name that is empty or `-`, where the
/// program runs) and the folders above it, as seen from where the program runs. Nothing where there is none.
std::optional<std::string> find_manifest(const std::string& first_file);

/// Reads the nearest `rmpl.toml`, and over it the nearest `rmpl.ini`, which are searched for alike. Throws
/// base::InputError where one cannot be read, or a key or value of it is not known.
Settings find_settings(const std::string& first_file);

/// Reads an rmpl.ini. `text` is what the file at `path` holds, `below` what counts where it says nothing.
Settings read_settings(const std::string& path, const std::string& text, const LintLevels& below = {});

}  // namespace rmpl::tools
