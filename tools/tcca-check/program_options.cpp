// Reading the options of tcca-check program.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/program_options.hpp"

#include <sstream>
#include <string_view>

namespace rmpl::tools {
namespace {

using Kind = verifier::ProgramProperty::Kind;

/// `φ within T`, or `φ` alone: then the time stands in `--within`.
Promise promise(const std::string& text) {
  constexpr std::string_view keyword = " within ";
  const std::size_t at = text.rfind(keyword);
  if (at == std::string::npos) return {text, std::nullopt};
  return {text.substr(0, at), duration(text.substr(at + keyword.size()))};
}

/// `φ within T ψ`
Answered answered(const std::string& text) {
  constexpr std::string_view keyword = " within ";
  const std::size_t at = text.find(keyword);
  if (at == std::string::npos) throw CLI::ValidationError("expected 'FORMULA within T FORMULA'");
  const std::string rest = text.substr(at + keyword.size());
  // The time is one word or two, `3s` or `3 s`.
  std::size_t end = rest.find(' ');
  if (end != std::string::npos && rest.find_first_not_of("0123456789.") == end) end = rest.find(' ', end + 1);
  if (end == std::string::npos) throw CLI::ValidationError("expected a time and a formula after 'within'");
  return {text.substr(0, at), duration(rest.substr(0, end)), rest.substr(end + 1)};
}

/// The properties that are the same for every program, by a list of their names.
std::vector<GeneralCheck> general_properties(const std::string& text) {
  std::vector<GeneralCheck> result;
  std::istringstream names(text);
  for (std::string name; std::getline(names, name, ',');) {
    const std::size_t before = result.size();
    for (const Kind kind : verifier::general_kinds) {
      if (name == verifier::name_of(kind)) result.push_back({kind});
      if (name == "all") result.push_back({kind, kind == Kind::undone});
    }
    if (result.size() == before) {
      throw CLI::ValidationError(
          "'" + name +
          "' is not known; expected goal-conflict, no-plan, endless-wait, termination, stuck, undone or all");
    }
  }
  return result;
}

void add_properties(CLI::App& command, ProgramOptions& options) {
  add_read(
      command, "--check", options.general, general_properties,
      "goal-conflict, no-plan, endless-wait, termination, stuck, undone, or all of them: what is checked where nothing "
      "else is asked")
      ->option_text("LIST");
  add_texts(command, "--never", options.nevers, "FORMULA", "what is never to hold up to the program's end");
  const auto take = [&options](const std::vector<std::string>& texts) {
    try {
      for (const std::string& text : texts) options.eventuallys.push_back(promise(text));
    } catch (const CLI::ValidationError& error) {
      throw CLI::ValidationError("--eventually", error.what());
    }
  };
  CLI::Option* eventually =
      repeatable(command
                     .add_option_function<std::vector<std::string>>(
                         "--eventually", take, "what is to come true in time, as 'FORMULA within T', or with --within")
                     ->option_text("FORMULA"));
  add_read(command, "--within", options.within, duration, "how soon, from the start")
      ->option_text("T")
      ->needs(eventually);
  const auto owe = [&options](const std::vector<std::string>& texts) {
    try {
      for (const std::string& text : texts) options.responses.push_back(answered(text));
    } catch (const CLI::ValidationError& error) {
      throw CLI::ValidationError("--after", error.what());
    }
  };
  repeatable(
      command
          .add_option_function<std::vector<std::string>>(
              "--after", owe, "each time the first formula holds the second follows, as 'FORMULA within T FORMULA'")
          ->option_text("FORMULA"));
  add_texts(command, "--finally", options.finallys, "FORMULA", "what is to hold where the program ends");
}

}  // namespace

std::vector<std::string> ProgramOptions::models() const {
  return plant.empty() ? std::vector{program} : std::vector{program, plant};
}

void add_program_options(CLI::App& command, ProgramOptions& options, Common& common) {
  command.add_option("PROGRAM", options.program, "the program: .rmpl, or a compiled .json of program and plant")
      ->required();
  command.add_option("PLANT", options.plant, "the plant: .tcca or compiled .json");
  add_text(command, "--main", options.entry, "NAME", "the definition to start with; else the one that no other calls");
  add_properties(command, options);
  add_freedom(command, options.freedom);
  CLI::Option* fewest =
      command
          .add_flag("--fewest-faults", options.fewest_faults,
                    "traces with the least number of faults there is; --faults says how many are tried")
          ->needs(command.get_option("--faults"));
  constexpr std::uint64_t most = 1'000'000;
  CLI::Option* cut_sets = add_whole_number(command, "--cut-sets", options.cut_sets, 0, most,
                                           "every minimal set of up to so many faults that leads to a violation")
                              ->option_text("N")
                              ->excludes(fewest)
                              ->excludes(command.get_option("--faults"));
  add_window(command, options.window);
  command.get_option("--not-before")->needs(command.get_option("--never"));
  command.get_option("--by")->needs(command.get_option("--never"));
  CLI::Option* each =
      command.add_flag("--each-fault", options.each_fault, "a table: every fault by itself, and what can come of it")
          ->excludes(command.get_option("--faults"))
          ->excludes(fewest)
          ->excludes(cut_sets)
          ->excludes(command.get_option("--fastest"));
  CLI::Option* scenario = add_text(command, "--scenario", options.scenario, "OUT.scn",
                                   "write the first violation as a scenario that fails the same way")
                              ->excludes(each);
  add_read(command, "--cycle", options.cycle, positive_duration,
           "the cycle of that scenario, where time is dense (default: 0.5s)")
      ->option_text("T")
      ->needs(scenario);
  add_report(command, options.report);
  add_budget(command, options.budget);
  add_format(command, common, true);
  command.add_flag("--stats", options.statistics, "tell what the check has cost");
}

}  // namespace rmpl::tools
