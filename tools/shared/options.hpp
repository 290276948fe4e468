// Options that programs have in common: read in one way, refused in the same words.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "automata/time/time.hpp"
#include "tools/shared/command.hpp"
#include "tools/shared/exit_status.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {

enum class Format { text, json, junit };

/// What every subcommand takes, and the form of what it answers.
struct Common {
  Color color = Color::automatic;
  Format format = Format::text;  ///< of results, and with json also of diagnostics
  bool measured = true;          ///< whether answers of tcca-check tell what they have cost
  bool quiet = false;
  bool verbose = false;
  std::size_t max_input = std::size_t{1} << 30;  ///< bytes that are read at once
};

/// What a signal that asks for an end does to a subcommand: it ends it, where there is nothing to tell before all is
/// done; or it is noted, and the subcommand ends soon with what it has found.
enum class AtSignal { end, tell };

/// A subcommand: declared at the start, run where it was called.
struct Subcommand {
  Command command;
  std::function<ExitStatus()> run;
  AtSignal at_signal = AtSignal::end;
};

void add_common(Command& command, Common& common);

/// An option whose text `read` turns into `value`, or refuses with BadValue.
template <class Value, class Read>
Option add_read(Command& command, const std::string& name, Value& value, const Read& read,
                const std::string& description) {
  return command.add_taken(
      name, [&value, read](const std::string& text) { value = read(text); }, description);
}

/// An option that takes one of a few words.
template <class Choice>
Option add_choice(Command& command, const std::string& name, Choice& value,
                  const std::vector<std::pair<std::string, Choice>>& choices, const std::string& description) {
  std::string words;
  for (const auto& [word, choice] : choices) words += (words.empty() ? "" : "|") + word;
  const auto read = [choices, words](const std::string& given) {
    for (const auto& [word, choice] : choices) {
      if (word == given) return choice;
    }
    throw BadValue("expected " + words + ", not '" + given + "'");
  };
  return add_read(command, name, value, read, description).option_text(words);
}

/// The form of an answer: `text` where nothing is said, else json or, where there is a suite of
/// verdicts, junit.
void add_format(Command& command, Common& common, bool junit = false);

/// What the whole text says, if it is a number.
std::optional<double> real_number(const std::string& text);
/// A whole number from `least` to `most`.
std::uint64_t whole_number(const std::string& text, std::uint64_t least, std::uint64_t most);
template <class Number>
Option add_whole_number(Command& command, const std::string& name, Number& value, std::uint64_t least,
                        std::uint64_t most, const std::string& description) {
  const auto read = [least, most](const std::string& text) {
    if constexpr (std::is_integral_v<Number>) {
      return static_cast<Number>(whole_number(text, least, most));
    } else {
      return static_cast<typename Number::value_type>(whole_number(text, least, most));
    }
  };
  return add_read(command, name, value, read, description).option_text("N");
}

/// A duration with or without a unit; `positive_duration` is finite and above 0. Throw BadValue.
automata::Ticks duration(const std::string& text);
automata::Ticks positive_duration(const std::string& text);
/// A number of bytes, perhaps in K, M or G of them (powers of 1024). Throws BadValue.
std::size_t memory_size(const std::string& text);

}  // namespace rmpl::tools
