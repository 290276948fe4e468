// What a live plant sends: answers to cycles, read strictly, one JSON object a line.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "automata/state.hpp"
#include "runtime/executive/live/inbox.hpp"
#include "runtime/executive/trace/log.hpp"

namespace rmpl::runtime {

/// One line that was read.
struct Answer {
  std::uint64_t cycle = 0;  ///< to which it belongs
  automata::Observation observations;
  std::vector<Sample> samples;
};

/// Reads the lines of one connection: `{"cycle": 7, "observations": {"engine.temp": "low"}}`; the other keys of a trace
/// are legal and not looked at (grammar/schema/live_answer.schema.json).
class Answers {
 public:
  /// Messages name the connection: `plant 2:17: …`. With monitors, an answer may
  /// have samples of their channels. Keeps references.
  Answers(const automata::Plant& plant, std::uint64_t connection, const Monitors* monitors);
  Answers(const Answers&) = delete;
  Answers& operator=(const Answers&) = delete;

  /// Throws base::InputError, located, where the line is no answer. Messages are one short line of printable text.
  Answer read(const Inbox::Line& line);
  /// Counts a line that is not read.
  void skip() { ++lines_, ++skipped_; }
  /// Where the next line would stand: `plant 2:18`.
  [[nodiscard]] std::string next_place() const;

 private:
  std::string name_;
  std::uint64_t lines_ = 0;
  std::size_t skipped_ = 0;  ///< since the last that was read
  std::stringstream text_;
  LogReader reader_;
};

}  // namespace rmpl::runtime
