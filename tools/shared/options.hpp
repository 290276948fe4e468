// Options that programs have in common: read in one way, refused in the same words.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "automata/time/time.hpp"
#include "tools/shared/exit_status.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {

enum class Format { text, json, junit };

/// What every subcommand takes, and the form of what it answers.
struct Common {
  Color color = Color::automatic;
  Format format = Format::text;  ///< of results, and with json also of diagnostics
  bool quiet = false;
  bool verbose = false;
  std::size_t max_input = std::size_t{1} << 30;  ///< bytes that are read at once
};

/// A subcommand: declared at the start, run where it was called.
struct Subcommand {
  CLI::App* app;
  std::function<ExitStatus()> run;
};

void add_common(CLI::App& app, Common& common);

/// An option whose text `read` turns into `value`, or refuses with CLI::ValidationError and a message.
template <class Value, class Read>
CLI::Option* add_read(CLI::App& app, const std::string& name, Value& value, const Read& read,
                      const std::string& description) {
  const auto take = [&value, read, name](const std::string& text) {
    try {
      value = read(text);
    } catch (const CLI::ValidationError& error) {
      throw CLI::ValidationError(name, error.what());
    }
  };
  return app.add_option_function<std::string>(name, take, description);
}

/// An option that takes one of a few words.
template <class Choice>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Choice& value,
                        const std::vector<std::pair<std::string, Choice>>& choices, const std::string& description) {
  std::string words;
  for (const auto& [word, choice] : choices) words += (words.empty() ? "" : "|") + word;
  const auto read = [choices, words](const std::string& given) {
    for (const auto& [word, choice] : choices) {
      if (word == given) return choice;
    }
    throw CLI::ValidationError("expected " + words + ", not '" + given + "'");
  };
  return add_read(app, name, value, read, description)->option_text(words);
}

/// The form of an answer: `text` where nothing is said, else json or, where there is a suite of
/// verdicts, junit.
void add_format(CLI::App& app, Common& common, bool junit = false);

/// A whole number from `least` to `most`.
std::uint64_t whole_number(const std::string& text, std::uint64_t least, std::uint64_t most);
template <class Number>
CLI::Option* add_whole_number(CLI::App& app, const std::string& name, Number& value, std::uint64_t least,
                              std::uint64_t most, const std::string& description) {
  const auto read = [least, most](const std::string& text) {
    if constexpr (std::is_integral_v<Number>) {
      return static_cast<Number>(whole_number(text, least, most));
    } else {
      return static_cast<typename Number::value_type>(whole_number(text, least, most));
    }
  };
  return add_read(app, name, value, read, description)->option_text("N");
}

/// An option that may be given several times, each time with one value: what follows is not its own.
CLI::Option* repeatable(CLI::Option* option);

/// One of the two options is given, and not both.
void require_one(CLI::App& command, CLI::Option* one, CLI::Option* other);

/// A duration with or without a unit; `positive_duration` is finite and above 0. Throw CLI::ValidationError.
automata::Ticks duration(const std::string& text);
automata::Ticks positive_duration(const std::string& text);
/// A number of bytes, perhaps in K, M or G of them (powers of 1024). Throws CLI::ValidationError.
std::size_t memory_size(const std::string& text);

}  // namespace rmpl::tools
