// The command line as subcommands see it: what they declare, and nothing of the parser.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace rmpl::tools {

/// The text of an option cannot be taken. The message says what was expected.
class BadValue : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An option, a flag or a positional argument of a command: a handle, which lives as long as the program.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required();
  /// What help says that it takes.
  Option option_text(const std::string& text);
  /// What help says that it does.
  Option description(const std::string& text);
  /// Both together are refused.
  Option excludes(Option other);
  /// It is refused without the other.
  Option needs(Option other);
  /// It may be given several times, each time with one value: what follows is not its own.
  Option repeatable();
  [[nodiscard]] bool given() const;
  [[nodiscard]] std::string name() const;
  [[nodiscard]] bool is_called(const std::string& name) const;
  [[nodiscard]] bool is_positional() const;

  bool operator==(const Option&) const = default;

 private:
  CLI::Option* option_;
};

/// A subcommand: a handle, which lives as long as the program. Names are `--long`, `-s`, `--long,-s` or `POSITIONAL`.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}

  Option add_option(const std::string& name, std::string& value, const std::string& description);
  /// May be given several times, or several at once.
  Option add_option(const std::string& name, std::vector<std::string>& values, const std::string& description);
  Option add_flag(const std::string& name, bool& value, const std::string& description);
  /// A flag that changes nothing.
  Option add_flag(const std::string& name, const std::string& description);
  /// A flag that makes the value false.
  Option add_negation(const std::string& name, bool& value, const std::string& description);
  /// `take` gets the text, or throws BadValue.
  Option add_taken(const std::string& name, const std::function<void(const std::string&)>& take,
                   const std::string& description);
  /// The same of all texts, of an option that is `repeatable`.
  Option add_all_taken(const std::string& name, const std::function<void(const std::vector<std::string>&)>& take,
                       const std::string& description);
  /// One of the two options is given, and not both.
  void require_one(Option one, Option other);
  /// Text below the options in help; `prepend_footer` puts it before what stands there.
  void footer(const std::string& text);
  void prepend_footer(const std::string& text);

  [[nodiscard]] Option option(const std::string& name) const;
  [[nodiscard]] std::vector<Option> options() const;
  [[nodiscard]] CLI::App& parser() const { return *app_; }

 private:
  CLI::App* app_;
};

}  // namespace rmpl::tools
