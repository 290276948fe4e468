// A program from its start to its exit code: parse, run the subcommand, tell what went wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "tools/shared/options.hpp"
#include "tools/shared/settings.hpp"

namespace rmpl::tools {

/// To be made first of all in `main`: from then on signals, lack of memory and closed descriptors are taken care of.
class Program {
 public:
  /// `name` and `version` last. `notes` stand below the list of subcommands in `--help`.
  Program(const char* name, const char* version, const char* description, const char* notes);

  [[nodiscard]] CLI::App& app() { return app_; }
  [[nodiscard]] Common& common() { return common_; }
  /// What `rmpl.ini` says; read by the time that a subcommand runs.
  [[nodiscard]] const Settings& settings() const { return settings_; }
  void add(Subcommand command) { commands_.push_back(std::move(command)); }

  /// Parses the command line and runs what it calls. Everything that is thrown ends here, in an exit code.
  int run(int count, const char* const* arguments) noexcept;

 private:
  ExitStatus parse_and_run(int count, const char* const* arguments);

  void take_settings(const CLI::App& command);

  CLI::App app_;
  Common common_;
  Settings settings_;
  std::vector<Subcommand> commands_;
};

/// The input is wrong, and its diagnostics have been told.
struct Rejected {};

}  // namespace rmpl::tools
