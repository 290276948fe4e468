// The files of scenarios that a command line names, with what is to be flown of each.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "compiler/session/compiler.hpp"
#include "tools/rmpl-run/flight.hpp"
#include "tools/rmpl-run/scenario_monitors.hpp"

namespace rmpl::tools {

/// A file that was compiled; or one that is wrong, whose diagnostics have been told; or one that an interruption left
/// unread.
struct ScenarioFile {
  std::string path;                                                    ///< as it was named
  std::shared_ptr<const compiler::Compilation> compilation = nullptr;  ///< which other files may have in common
  std::size_t first = 0;                                               ///< of its scenarios in the document
  std::size_t count = 0;                                               ///< how many it has there
  std::string wrong = {};  ///< why it is wrong, lines ended; empty: it is not

  /// The scenarios of a file that was compiled.
  [[nodiscard]] std::span<const automata::Scenario> scenarios() const {
    return std::span(compilation->document().scenarios).subspan(first, count);
  }
};

/// Reads the files in their order, up to an interruption. A single file that is wrong throws Rejected or
/// base::InputError; of several, those that are wrong take nothing from the others. Files of one folder of which there
/// is nothing to say are compiled together: a plant and a program that they have in common, once.
std::vector<ScenarioFile> read_scenarios(const std::vector<std::string>& paths, const ScenarioMonitors& monitors,
                                         const Common& common);

/// The scenarios that were asked for, in the order of the files, which outlive them. Throws base::InputError where a
/// name is unknown.
std::vector<Task> tasks_of(const std::vector<ScenarioFile>& files, const FlightOptions& options);

}  // namespace rmpl::tools
