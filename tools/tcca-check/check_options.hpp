// What the subcommands of tcca-check have in common: what is free, what it may cost, the form of the answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "automata/origin.hpp"
#include "automata/plant.hpp"
#include "tools/shared/options.hpp"
#include "verifier/property/commands.hpp"
#include "verifier/property/property.hpp"
#include "verifier/search/limits.hpp"
#include "verifier/slice/slices.hpp"
#include "verifier/verdict/answer.hpp"

namespace rmpl::tools {

/// Of a run: the reading of time, faults, the start.
struct Freedom {
  std::optional<automata::Ticks> period;  ///< none: dense time
  bool dense = false;                     ///< which was asked for
  std::optional<unsigned> faults;         ///< as it was given
  bool entailed = false;
  std::string from;  ///< assignments; empty: the initial distribution
};
/// As good as any number of them.
inline constexpr unsigned most_faults = 1'000'000;
/// `formula`: what is asked has one, to be read in either way.
void add_freedom(Command& command, Freedom& freedom, bool formula = true);

/// What a search may cost.
struct Budget {
  std::optional<std::size_t> states;
  std::optional<automata::Ticks> time;
  std::optional<std::size_t> bytes;

  /// As the answer repeats them.
  [[nodiscard]] verifier::Bounds bounds() const { return {states, time, bytes}; }
};
void add_budget(Command& command, Budget& budget);
/// The limits of a search that signals end, and that shows its progress where somebody sees it.
verifier::Limits limits(const Budget& budget, const Common& common);

/// Where to write a page with the traces.
void add_report(Command& command, std::string& path);
void add_model(Command& command, std::string& model);
/// The same, with the definition that it starts with where it is a model program.
void add_model(Command& command, std::string& model, std::string& main);
void add_commands(Command& command, verifier::Commands& commands);
/// An option that takes a formula or a name, and may be given several times where it fills a list.
Option add_text(Command& command, const std::string& name, std::string& text, const char* type,
                const char* description);
Option add_texts(Command& command, const std::string& name, std::vector<std::string>& texts, const char* type,
                 const char* description);

/// The form of an answer: text, json or junit, and whether it tells what it has cost.
void add_answer_form(Command& command, Common& common, bool& statistics);

/// An answer without what it has cost, so that every run gives the same bytes.
void forget_statistics(nlohmann::ordered_json& answer);
void forget_times(std::string& junit);

/// Writes an answer in the form that was asked for, by the function that makes that form.
template <class Text, class Json, class Junit>
void print_answer(const Common& common, const Text& text, const Json& json, const Junit& junit) {
  switch (common.format) {
    case Format::text:
      return print(text());
    case Format::json: {
      nlohmann::ordered_json answer = json();
      if (!common.measured) forget_statistics(answer);
      return print_json(answer.dump(2) + "\n");
    }
    case Format::junit: {
      std::string answer = junit();
      if (!common.measured) forget_times(answer);
      return print_file(answer);
    }
  }
}

ExitStatus status_of(verifier::Verdict verdict);

/// Where questions of a file are stated, one by one; nothing for those of the command line.
struct Stated {
  std::string name;
  automata::Origin origin;
  bool allowed = false;  ///< a comment allows that it says nothing
};

/// What there is to be warned of in each question; told, each text once, with the property and where it is stated.
/// `program`: that questions about one are asked of, if there is one.
std::vector<std::vector<std::string>> warn_of_questions(const std::vector<verifier::Question>& questions,
                                                        verifier::Slices& slices, const automata::Program* program,
                                                        const Common& common, const std::vector<Stated>& stated = {});
/// Puts that beside the answers, with what there is to be warned of in those, which is told too.
void warn_of_answers(const std::vector<verifier::Question>& questions, std::vector<std::vector<std::string>> warnings,
                     std::vector<verifier::Answer>& answers, verifier::Slices& slices, const Common& common,
                     const std::vector<Stated>& stated = {});

}  // namespace rmpl::tools
