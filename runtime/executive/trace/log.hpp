// A log: what was commanded, observed or estimated, one JSON object a line. Read and checked in full before it is used.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "automata/time/time.hpp"

namespace rmpl::runtime {

/// What one line says; what it does not say is empty. The other keys of a trace are legal and not kept.
struct LogLine {
  std::size_t number = 0;  ///< of the line in the file, from 1
  std::optional<std::uint64_t> cycle;
  automata::Ticks time;  ///< where the line has none: that of the line before, or 0
  std::optional<std::vector<automata::Assignment>> estimate;  ///< sorted by variable, like all of these
  std::vector<automata::Assignment> command;                  ///< control variables
  automata::Observation observations;
};

/// Reads a log over a plant's names. `name` is the file's, for messages. Blank lines are skipped. Throws
/// base::InputError, located by line, where a line is no JSON object, has a key twice or one that no trace has, a value
/// of the wrong type, a name or value that the plant lacks (with the nearest one), an observed mode, or a time that
/// lies before that of an earlier line.
std::vector<LogLine> read_log(std::istream& in, const std::string& name, const automata::Plant& plant);

/// Reads a log whose names are taken as they come: variables and values that `variables` lacks are added to it.
std::vector<LogLine> read_log(std::istream& in, const std::string& name, automata::Variables& variables);

}  // namespace rmpl::runtime
