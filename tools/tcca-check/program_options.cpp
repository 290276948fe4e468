// Reading the options of tcca-check program.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/program_options.hpp"

#include <sstream>

namespace rmpl::tools {
namespace {

using Kind = verifier::ProgramProperty::Kind;

/// The properties that are the same for every program, by a list of their names.
std::vector<GeneralCheck> general_properties(const std::string& text) {
  std::vector<GeneralCheck> result;
  std::istringstream names(text);
  for (std::string name; std::getline(names, name, ',');) {
    const std::size_t before = result.size();
    for (const Kind kind : verifier::general_kinds) {
      if (name == verifier::name_of(kind)) result.push_back({kind});
      if (name == "all") result.push_back({kind, true});
    }
    if (result.size() == before) {
      throw BadValue(
          "'" + name +
          "' is not known; expected goal-conflict, no-plan, endless-wait, termination, stuck, undone or all");
    }
  }
  return result;
}

void add_properties(Command& command, ProgramOptions& options) {
  add_read(command, "--check", options.general, general_properties,
           "goal-conflict, no-plan, endless-wait, termination, stuck, undone, or all (the default, unless a formula is "
           "given)")
      .option_text("LIST");
  add_texts(command, "--never", options.nevers, "FORMULA",
            "a formula that must never hold before the program has ended");
  const auto promise = [&options](const std::string& text) { options.eventuallys.push_back(timed_formula(text)); };
  const auto owe = [&options](const std::string& text) { options.responses.push_back(timed_response(text)); };
  const auto add = [&command](const char* name, const auto& read, const char* description) {
    const auto take = [read](const std::vector<std::string>& texts) {
      for (const std::string& text : texts) read(text);
    };
    command.add_all_taken(name, take, description).option_text("FORMULA").repeatable();
  };
  add("--eventually", promise, "a formula that must become true in time, as 'FORMULA within T', or with --within");
  add("--after", owe,
      "whenever the first formula holds, the second must follow, as 'FORMULA within T FORMULA', or with --within");
  add_read(command, "--within", options.within, timed_formula,
           "the time limit from the start; for --after the time and the response; inf: no limit")
      .option_text("T [FORMULA]");
  add_texts(command, "--finally", options.finallys, "FORMULA", "a formula that must hold when the program ends");
}

}  // namespace

std::vector<std::string> ProgramOptions::models() const {
  return plant.empty() ? std::vector{program} : std::vector{program, plant};
}

void add_program_options(Command& command, ProgramOptions& options, Common& common) {
  command.add_option("PROGRAM", options.program, "the program: .rmpl, or a compiled .json of program and plant")
      .required();
  command.add_option("PLANT", options.plant, "the plant: .tcca or compiled .json");
  add_text(command, "--main", options.entry, "NAME",
           "the definition to start with (default: the one that no other definition calls)");
  add_properties(command, options);
  add_freedom(command, options.freedom);
  Option fewest = command
                      .add_flag("--fewest-faults", options.fewest_faults,
                                "find a trace with the fewest faults; --faults limits their number")
                      .needs(command.option("--faults"));
  constexpr std::uint64_t most = 1'000'000;
  Option cut_sets = add_whole_number(command, "--cut-sets", options.cut_sets, 0, most,
                                     "find every minimal set of up to K faults that leads to a violation")
                        .option_text("N")
                        .excludes(fewest)
                        .excludes(command.option("--faults"));
  Option allow_stuck =
      command.add_flag("--allow-stuck", options.allow_stuck, "do not check for deadlocks and timelocks");
  add_window(command, options.window);
  command.option("--not-before").needs(command.option("--never"));
  command.option("--by").needs(command.option("--never"));
  Option each = command.add_flag("--each-fault", options.each_fault, "a table of single faults and their outcomes")
                    .excludes(command.option("--faults"))
                    .excludes(fewest)
                    .excludes(cut_sets)
                    .excludes(command.option("--fastest"))
                    .excludes(allow_stuck);
  Option scenario = add_text(command, "--scenario", options.scenario, "OUT.scn",
                             "write the first violation as a scenario that fails in the same way")
                        .excludes(each);
  add_read(command, "--cycle", options.cycle, positive_duration,
           "the cycle of that scenario if time is dense (default: 0.5s)")
      .option_text("T")
      .needs(scenario);
  add_report(command, options.report);
  add_budget(command, options.budget);
  add_answer_form(command, common, options.statistics);
}

}  // namespace rmpl::tools
