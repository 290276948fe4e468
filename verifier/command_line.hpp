// The command line of tcca-check, as written: what needs a plant to be understood stays text.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "automata/time.hpp"
#include "verifier/explore/commands.hpp"

namespace verifier {

struct CommandLine {
  enum class Kind { reachability, safety, response };
  enum class Format { text, json };
  enum class Color { automatic, always, never };

  Kind kind = Kind::reachability;
  std::string model;          ///< a path, or `-`
  std::string target, never;  ///< formulas, by kind
  std::string after, then;
  automata::Ticks within;
  std::optional<automata::Ticks> period;  ///< none: dense time
  std::optional<automata::Ticks> not_before, by;
  bool fastest = false;
  unsigned faults = 0;
  Commands commands = Commands::one;
  bool entailed = false;
  std::string from;  ///< assignments; empty: the initial distribution
  std::optional<std::size_t> max_states;
  std::optional<automata::Ticks> timeout;
  std::optional<std::size_t> max_bytes;
  Format format = Format::text;
  bool statistics = false;
  Color color = Color::automatic;
  bool quiet = false;
  bool verbose = false;
};

/// What came of reading the arguments: a command line, or text to print and the status to exit with.
struct ParsedCommandLine {
  std::optional<CommandLine> command_line;
  std::string message;
  bool failed = false;  ///< the message is an error; otherwise it is help or the version that was asked for
};

/// `arguments` are those of main; `version` is what `--version` prints.
ParsedCommandLine parse_command_line(int count, const char* const* arguments, const std::string& version);

}  // namespace verifier
