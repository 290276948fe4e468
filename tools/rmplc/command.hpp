// The subcommands of rmplc: each does what the settings of its command line say, and returns the exit code.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "compiler/session/compiler.hpp"

namespace rmpl::compiler {

/// Exit codes of the program.
inline constexpr int done = 0;
inline constexpr int wrong_input = 2;
inline constexpr int limit_hit = 3;

/// What the command line says; each subcommand reads its own part.
struct Settings {
  std::vector<std::string> files;
  std::string output;
  std::string main;
  std::string format = "text";
  std::string color = "auto";
  std::string code;
  std::string circuit;
  std::string faults = "weak";
  bool quiet = false;
  bool verbose = false;

  /// Whether diagnostics are coloured.
  [[nodiscard]] bool colored() const;
};

// All throw base::InputError where the world does not play along.
int run_compile(const Settings& settings);
int run_import(const Settings& settings);
int run_explain(const Settings& settings);

}  // namespace rmpl::compiler
