// How a log is to be read: the options of the subcommands that take one.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/monitor.hpp"
#include "automata/plant.hpp"
#include "runtime/telemetry/log_times.hpp"
#include "tools/shared/options.hpp"

namespace rmpl::tools {

struct LogOptions {
  runtime::LogTimeOptions times;
  std::string monitors_file;                ///< empty: none
  std::vector<automata::Monitor> monitors;  ///< what it says, once it was compiled
  std::string time_column;
  std::optional<char> delimiter;
  bool script = false;                    ///< whether it is a scenario of Livingstone2
  std::optional<automata::Ticks> period;  ///< of the cycles; none: a line of the log is one
  bool quiet = false;                     ///< whether what is odd is not told
  bool samples = true;                    ///< of a table: whether lines have what was sampled, which is never wrong
};

/// `--origin` and `--time-unit`.
void add_log_times(Command& command, LogOptions& options);
/// `--monitors`, `--time-column`, `--delimiter` and `--cycle`.
void add_telemetry(Command& command, LogOptions& options);

/// Compiles the file of monitors over a plant. Throws Rejected where it is wrong.
std::vector<automata::Monitor> load_monitors(const std::string& path, const automata::Plant& plant,
                                             const Common& common);

}  // namespace rmpl::tools
