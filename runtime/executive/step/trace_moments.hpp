// What a trace or a witness tells, moment by moment.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/program.hpp"
#include "automata/state.hpp"
#include "runtime/executive/step/stop.hpp"

namespace rmpl::runtime {

/// The end of a cycle, or an event.
struct TraceMoment {
  Stop stop;
  std::optional<automata::Modes> truth;
  automata::Modes estimate;  ///< of a witness the truth
  automata::ControlAction command;
  automata::Observation observations, set_aside;
  bool no_plan = false;
  std::vector<std::string> story;  ///< what the executive was not told, and the like
};

/// Reads all of a text: JSON Lines as `rmpl-run scenario --trace` writes them, or the object that `tcca-check --format
/// json` prints, of which the trace counts. At least one moment; times never fall. `name` is the file's, for messages.
/// Throws base::InputError, located by file and line, where it is no such thing, or speaks of another plant.
std::vector<TraceMoment> read_moments(const automata::Plant& plant, const automata::Program& program,
                                      const std::string& text, const std::string& name);

}  // namespace rmpl::runtime
