// What the subcommands read: models, formulas and logs, with their errors on standard error.
// SPDX-License-Identifier: MIT
#pragma once

#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "automata/scenario.hpp"
#include "compiler/session/compiler.hpp"
#include "tools/rmpl-run/command.hpp"

namespace rmpl::runtime {

/// Compiles the files and prints their diagnostics; nothing where they have errors. Throws base::InputError where a
/// file cannot be read.
std::optional<compiler::Compilation> load(const std::vector<std::string>& paths, const Common& common,
                                          const compiler::Options& options = {});

/// The one plant, or control program, that an input set holds. Throw base::InputError where there is none.
const automata::Plant& only_plant(const automata::Document& document, const std::string& path);
const automata::Program& only_program(const automata::Document& document, const std::string& path);

/// A formula or assignments that stand on the command line, as the option `where`; nothing, and diagnostics on
/// standard error, where they are wrong. Assignments come sorted, each once; base::InputError where two contradict.
std::optional<automata::Formula> formula_option(const std::string& text, const automata::Plant& plant,
                                                std::string_view where, const Common& common);
std::optional<std::vector<automata::Assignment>> assignments_option(const std::string& text,
                                                                    const automata::Plant& plant,
                                                                    std::string_view where, const Common& common);

/// A text file, or standard input for `-`. Throws base::InputError where it cannot be opened.
class TextInput {
 public:
  explicit TextInput(const std::string& path);
  std::istream& stream() { return *stream_; }
  /// For messages.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
  std::unique_ptr<std::istream> file_;
  std::istream* stream_;
};

/// Throws base::InputError where more than one of the paths is `-`: standard input can be read once.
void check_standard_input(const std::vector<std::string>& paths);

/// Flushes standard output. Throws base::InputError where what was written did not get there.
void finish_output();

}  // namespace rmpl::runtime
