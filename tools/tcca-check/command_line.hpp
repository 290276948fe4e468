// The command line of tcca-check, as written: what needs a plant to be understood stays text.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "automata/time/time.hpp"
#include "verifier/property/commands.hpp"
#include "verifier/property/property.hpp"

namespace rmpl::verifier {

/// A constraint that is to come true in time.
struct Promise {
  std::string constraint;
  std::optional<automata::Ticks> within;  ///< nothing: as `--within` says
};

struct CommandLine {
  enum class Kind { reachability, safety, response, program, check_file, export_model };
  enum class Format { text, json, junit };
  /// The tools that a model can be written for.
  enum class Tool { tchecker, uppaal, prism };
  enum class Color { automatic, always, never };

  Kind kind = Kind::reachability;
  std::vector<std::string> models;  ///< paths, or `-`: one, of a program perhaps two
  std::string target, never;        ///< formulas, by kind
  std::string after, then;
  automata::Ticks within;
  // Of a program:
  std::string entry;                           ///< the definition to start with; empty: the one that no other calls
  std::vector<ProgramProperty::Kind> general;  ///< of the properties that hold for any program, those asked for
  std::vector<std::string> nevers, finallys;
  std::vector<Promise> eventuallys;
  bool each_fault = false;
  std::string scenario;  ///< where to write a witness as a scenario; empty: nowhere
  automata::Ticks cycle = {automata::Ticks::per_second / 2};  ///< of that scenario, where time is dense
  // Of a file of properties:
  std::string properties;         ///< a path, or `-`
  std::vector<std::string> only;  ///< the names of those to check; empty: all

  std::optional<automata::Ticks> period;  ///< none: dense time
  std::optional<automata::Ticks> not_before, by;
  bool fastest = false;
  unsigned faults = 0;
  bool faults_given = false;
  bool fewest_faults = false;
  bool no_symmetry = false;
  unsigned threads = 1;              ///< as many as the machine runs at once, unless given
  std::optional<unsigned> cut_sets;  ///< the most faults that such a set may hold
  Commands commands = Commands::one;
  bool entailed = false;
  std::string from;  ///< assignments; empty: the initial distribution
  std::optional<std::size_t> max_states;
  std::optional<automata::Ticks> timeout;
  std::optional<std::size_t> max_bytes;
  Format format = Format::text;
  bool statistics = false;
  Tool tool = Tool::tchecker;
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

}  // namespace rmpl::verifier
