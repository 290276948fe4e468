// rmpl.toml: which files make a project, and how they are checked.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/shared/lint_levels.hpp"

namespace rmpl::tools {

inline constexpr const char* manifest_name = "rmpl.toml";

/// A text of the manifest, with its place.
struct ManifestText {
  std::string text;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

/// Files that belong together: a plant, a program that controls it, what is flown and what is claimed.
struct ManifestSet {
  std::string name;
  std::uint32_t line = 0;
  // As they stand there, relative to the manifest.
  std::optional<ManifestText> plant;
  std::optional<ManifestText> program;
  std::optional<ManifestText> main;  ///< the definition to start with
  // Names or patterns.
  std::vector<ManifestText> scenarios;
  std::vector<ManifestText> properties;
  std::vector<ManifestText> monitors;
};

struct Manifest {
  std::string path;                        ///< as it was named
  std::string name;                        ///< of the project; empty where it does not say
  std::vector<ManifestText> requirements;  ///< that its tests are to verify
  LintLevels lint;
  std::optional<ManifestText> baseline;  ///< findings that are known, relative to the manifest
  /// Options of subcommands, by `program.subcommand`: what the command line would say, without dashes.
  std::map<std::string, std::map<std::string, ManifestText>> options;
  std::vector<ManifestSet> sets;  ///< in the order of the file

  /// Throws base::InputError with a place of the manifest.
  [[noreturn]] void fail(const ManifestText& at, const std::string& what) const;
  /// With the place before it.
  [[nodiscard]] std::string told(const ManifestText& at, const std::string& what) const;
};

/// Reads one; `text` is what the file at `path` holds. Throws base::InputError, a line with its place for each thing
/// that is wrong.
Manifest read_manifest(const std::string& path, const std::string& text);

/// The file of known findings, as seen from where the program runs; empty: none. Throws base::InputError where it is
/// not there.
std::string baseline_of(const Manifest& manifest);

/// The files of a set, as seen from where the program runs. Of a name that stands for no file, or a pattern that
/// matches none, `files_of` throws base::InputError.
struct SetFiles {
  std::string plant, program, main;  ///< empty: none
  std::vector<std::string> scenarios, properties, monitors;
};
SetFiles files_of(const Manifest& manifest, const ManifestSet& set);

}  // namespace rmpl::tools
