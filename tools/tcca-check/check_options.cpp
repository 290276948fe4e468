// Options of tcca-check that several subcommands take.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/check_options.hpp"

#include <cstdio>
#include <set>
#include <utility>

#include "automata/place.hpp"
#include "grammar/source/codes.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/progress.hpp"
#include "verifier/slice/warnings.hpp"

namespace rmpl::tools {

using verifier::Commands;
using verifier::Verdict;

void add_freedom(Command& command, Freedom& freedom, bool formula) {
  const auto period = [&freedom](const std::string& text) {
    freedom.dense = text == "dense";
    return freedom.dense ? std::nullopt : std::optional(positive_duration(text));
  };
  add_read(command, "--time", freedom.period, period,
           "dense time (the default), or the period at whose multiples steps happen")
      .option_text("dense|T");
  add_whole_number(command, "--faults", freedom.faults, 0, most_faults, "the most faults that may happen (default: 0)")
      .option_text("K");
  if (formula) {
    command.add_flag("--entailed", freedom.entailed,
                     "a formula holds if the constraints imply it, not if they merely allow it");
  }
  add_text(command, "--from", freedom.from, "MODES",
           "initial modes, such as 'engine = off'; other components start as in the plant");
}

void add_budget(Command& command, Budget& budget) {
  constexpr std::uint64_t most = 1'000'000'000'000;
  add_whole_number(command, "--max-states", budget.states, 1, most, "stop after this number of symbolic states");
  add_read(command, "--timeout", budget.time, duration, "stop after this time").option_text("T");
  add_read(command, "--max-memory", budget.bytes, memory_size, "stop at this memory use").option_text("BYTES[K|M|G]");
}

verifier::Limits limits(const Budget& budget, const Common& common) {
  verifier::Limits result{budget.states, std::nullopt, budget.bytes, &interruption(), nullptr};
  if (budget.time && !budget.time->is_infinite()) result.time.emplace(budget.time->seconds());
  if (progress_is_seen(common.quiet)) {
    result.report = [](const verifier::Progress& p) {
      char seconds[32];
      std::snprintf(seconds, sizeof seconds, "%.0f", p.seconds);
      show_progress(std::string(seconds) + " s: " + std::to_string(p.states) + " states, " + std::to_string(p.waiting) +
                    " unexplored, " + std::to_string(p.steps.value_or(p.level)) + (p.steps ? " steps" : " faults"));
    };
  }
  return result;
}

void add_report(Command& command, std::string& path) {
  add_text(command, "--report", path, "OUT.html", "write a page to look at the traces in a browser, all in one file");
}

void add_model(Command& command, std::string& model) {
  command
      .add_option("MODEL", model, "the plant: .tcca, .rmpl (a model program) or compiled .json; - for standard input")
      .required();
}

void add_model(Command& command, std::string& model, std::string& main) {
  add_model(command, model);
  add_text(command, "--main", main, "NAME",
           "the definition that a model program starts with (default: the one that no other calls)");
}

void add_commands(Command& command, Commands& commands) {
  add_choice<Commands>(command, "--commands", commands,
                       {{"none", Commands::none}, {"one", Commands::one}, {"any", Commands::any}},
                       "how many controls may be off their idle value in one step (default: one)");
}

Option add_text(Command& command, const std::string& name, std::string& text, const char* type,
                const char* description) {
  return command.add_option(name, text, description).option_text(type);
}

Option add_texts(Command& command, const std::string& name, std::vector<std::string>& texts, const char* type,
                 const char* description) {
  return command.add_option(name, texts, description).option_text(type).repeatable();
}

void add_answer_form(Command& command, Common& common, bool& statistics) {
  add_format(command, common, true);
  Option with = command.add_flag("--stats", statistics, "print the cost of the search");
  command
      .add_negation("--no-statistics", common.measured,
                    "omit times and memory from json and junit, so that output is reproducible")
      .excludes(with);
}

void forget_statistics(nlohmann::ordered_json& answer) {
  if (answer.is_object()) answer.erase("statistics");
  for (nlohmann::ordered_json& inner : answer) {
    if (inner.is_structured()) forget_statistics(inner);
  }
}

void forget_times(std::string& junit) {
  static constexpr std::string_view attribute = " time=\"";
  for (std::size_t at = junit.find(attribute); at != std::string::npos; at = junit.find(attribute, at)) {
    junit.erase(at, junit.find('"', at + attribute.size()) + 1 - at);
  }
}

ExitStatus status_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return ExitStatus::done;
    case Verdict::violated:
      return ExitStatus::violated;
    case Verdict::undecided:
      return ExitStatus::undecided;
  }
  return ExitStatus::internal_error;
}

namespace {

/// Whether anybody is to hear of warnings: they are part of what machines read, however quiet it is.
bool warnings_are_wanted(const Common& common) { return !common.quiet || common.format != Format::text; }

/// Each text once; of a property of a file with its place and name, so that one sees which it is of several.
class Warnings {
 public:
  explicit Warnings(const std::vector<Stated>& stated) : stated_(stated) {}

  /// `says_nothing`: lint finds the same in the file, under this code.
  void tell(std::size_t question, const std::string& text, bool says_nothing) {
    std::string line = "warning: ";
    if (question < stated_.size()) {
      const Stated& own = stated_[question];
      if (says_nothing && own.allowed) return;
      line = automata::short_place(own.origin) + ": warning";
      if (says_nothing) line += "[" + grammar::to_string(grammar::Code::vacuous_property) + "]";
      line += ": property \"" + own.name + "\": ";
    }
    line += text;
    if (told_.insert(line).second) tools::tell(line);
  }

 private:
  const std::vector<Stated>& stated_;
  std::set<std::string> told_;
};

}  // namespace

std::vector<std::vector<std::string>> warn_of_questions(const std::vector<verifier::Question>& questions,
                                                        verifier::Slices& slices, const automata::Program* program,
                                                        const Common& common, const std::vector<Stated>& stated) {
  std::vector<std::vector<std::string>> result(questions.size());
  if (!warnings_are_wanted(common)) return result;
  Warnings warnings(stated);
  for (std::size_t q = 0; q < questions.size(); ++q) {
    for (const verifier::QuestionWarning& warning : verifier::warnings_of(questions[q], slices, program)) {
      result[q].push_back(warning.text);
      if (!common.quiet) warnings.tell(q, warning.text, warning.says_nothing);
    }
  }
  return result;
}

void warn_of_answers(const std::vector<verifier::Question>& questions, std::vector<std::vector<std::string>> warnings,
                     std::vector<verifier::Answer>& answers, verifier::Slices& slices, const Common& common,
                     const std::vector<Stated>& stated) {
  Warnings told(stated);
  for (std::size_t q = 0; q < questions.size(); ++q) {
    verifier::Answer& answer = answers[q];
    answer.warnings = std::move(warnings[q]);
    // That an answer is about nothing at all is told in any case.
    if (!warnings_are_wanted(common) && !answer.startless) continue;
    auto warning = verifier::warning_of(questions[q], answer, slices);
    if (!warning) continue;
    // That nothing starts is about the plant, and no property.
    if (!common.quiet || answer.startless) told.tell(answer.startless ? stated.size() : q, *warning, false);
    answer.warnings.push_back(std::move(*warning));
  }
}

}  // namespace rmpl::tools
