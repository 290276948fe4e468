// A program from its start to its exit code: parse, run the subcommand, tell what went wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/shared/options.hpp"
#include "tools/shared/settings.hpp"

namespace rmpl::tools {

/// To be made first of all in `main`: from then on signals, lack of memory and closed descriptors are taken care of.
class Program {
 public:
  /// `name` and `version` last. `notes` stand below the list of subcommands in `--help`.
  Program(const char* name, const char* version, const char* description, const char* notes);

  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  /// Declares a subcommand; `add` tells what it does.
  Command add_command(const char* name, const char* description);
  [[nodiscard]] Common& common() { return common_; }
  /// What `rmpl.ini` and `rmpl.toml` say; read by the time that a subcommand runs.
  [[nodiscard]] const Settings& settings() const { return settings_; }
  void add(Subcommand command) { commands_.push_back(std::move(command)); }

  /// Parses the command line and runs what it calls. Everything that is thrown ends here, in an exit code.
  int run(int count, const char* const* arguments) noexcept;

 private:
  ExitStatus parse_and_run(int count, const char* const* arguments);

  void take_settings(CLI::App& command);
  /// The options of the command that stand in the manifest. Throws base::InputError, also where another of this
  /// program's subcommands is one that there is not.
  void take_defaults(CLI::App& command) const;
  void print_failure(const std::string& text) noexcept;

  std::unique_ptr<CLI::App> app_;
  Common common_;
  Settings settings_;
  std::vector<Subcommand> commands_;
};

/// The input is wrong, and its diagnostics have been told.
struct Rejected {
  std::string text = {};  ///< the same once more, for a form that has a place for it; lines ended
};

}  // namespace rmpl::tools
