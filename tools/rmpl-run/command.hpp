// The subcommands of rmpl-run: each declares its options, and runs when it was the one that was called.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace rmpl::runtime {

/// Exit codes of the program.
enum class Status : int {
  done = 0,      ///< done; all expectations met
  failed = 1,    ///< an expectation failed; there is no plan
  wrong = 2,     ///< the command line or an input is wrong; nothing was written
  undecided = 3  ///< interrupted, or a limit was hit
};

enum class Color { automatic, always, never };
enum class Format { text, json };

/// What every subcommand takes.
struct Common {
  Color color = Color::automatic;
  bool quiet = false;
  bool verbose = false;

  /// Whether to colour what goes to standard output, or to standard error.
  [[nodiscard]] bool color_output() const;
  [[nodiscard]] bool color_errors() const;
};

struct Subcommand {
  CLI::App* app;
  std::function<Status()> run;
};

// Each adds itself to `app`; `common` outlives the run.
Subcommand scenario_command(CLI::App& app, const Common& common);
Subcommand estimate_command(CLI::App& app, const Common& common);
Subcommand sequence_command(CLI::App& app, const Common& common);
Subcommand plan_command(CLI::App& app, const Common& common);
Subcommand diagnose_command(CLI::App& app, const Common& common);

/// An option that takes one of a few words.
template <class Choice>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Choice& target,
                        const std::vector<std::pair<std::string, Choice>>& choices, const std::string& description) {
  std::string words;
  for (const auto& [word, choice] : choices) words += (words.empty() ? "" : "|") + word;
  const auto take = [name, &target, choices, words](const std::string& given) {
    for (const auto& [word, choice] : choices) {
      if (word != given) continue;
      target = choice;
      return;
    }
    throw CLI::ValidationError(name, "expected " + words + ", not '" + given + "'");
  };
  return app.add_option_function<std::string>(name, take, description)->option_text(words);
}

/// `--format text|json`.
inline void add_format(CLI::App& app, Format& format) {
  add_choice<Format>(app, "--format", format, {{"text", Format::text}, {"json", Format::json}},
                     "text for people, json for programs (default: text)");
}

/// `-k N` of an estimator.
template <class Count>
void add_k(CLI::App& app, Count& k) {
  app.add_option("-k", k, "how many states k-best keeps (default: 16)")
      ->option_text("N")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}));
}

}  // namespace rmpl::runtime
