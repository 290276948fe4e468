// From text to trees: the entrances.
// SPDX-License-Identifier: MIT
#include "grammar/parse/parse.hpp"

#include "grammar/parse/monitor_rule.hpp"
#include "grammar/parse/parse_monitors.hpp"
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {
namespace {

/// The tree of a whole text, or of a part where it has errors. `clocks`: the language has them.
template <class Parser, class Tree>
Parse<Tree> parse_whole(const Parser& parser, Tree tree, const Sources& sources, std::uint32_t file,
                        Diagnostics& diagnostics, bool clocks = false) {
  const std::size_t errors_before = diagnostics.error_count();
  if (sources[file].is_cut()) {
    diagnostics.error(Code::text_too_long, {file, 0, 0}, "text too long: at most 4 GiB were expected");
    return {std::move(tree), false};
  }
  if (!check_encoding(sources, file, diagnostics)) return {std::move(tree), false};
  ParseState state(sources, file, diagnostics, clocks);
  const Context context = x3::make_context<StateTag>(state);
  Iterator first = state.begin();
  if (sources[file].text().starts_with("\xEF\xBB\xBF")) first += 3;  // a byte order mark
  const Iterator last = state.end();
  try {
    recovering<Resume::over_braces>[parser].parse(first, last, context, x3::unused, tree);
    recovering<Resume::over_braces>[end_of_text].parse(first, last, context, x3::unused, x3::unused);
  } catch (const Abandoned&) {
    return {std::move(tree), false};
  }
  return {std::move(tree), diagnostics.error_count() == errors_before};
}

}  // namespace

Parse<ProgramFile> parse_program(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics) {
  return parse_whole(program_file, ProgramFile{}, sources, file, diagnostics, true);
}

Parse<PlantFile> parse_plant(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics) {
  return parse_whole(plant_file, PlantFile{}, sources, file, diagnostics);
}

Parse<ScenarioFile> parse_scenarios(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics) {
  return parse_whole(scenario_file, ScenarioFile{}, sources, file, diagnostics);
}

Parse<PropertyFile> parse_properties(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics) {
  return parse_whole(property_file, PropertyFile{}, sources, file, diagnostics);
}

Parse<MonitorFile> parse_monitors(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics) {
  return parse_whole(monitor_file, MonitorFile{}, sources, file, diagnostics);
}

Parse<Constraint> parse_constraint(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics) {
  return parse_whole(constraint, Constraint{}, sources, file, diagnostics);
}

Parse<std::vector<AssignmentText>> parse_assignments(const Sources& sources, std::uint32_t file,
                                                     Diagnostics& diagnostics) {
  auto list = parse_whole(assignment_list, AssignmentListText{}, sources, file, diagnostics);
  return {std::move(list.tree.assignments), list.whole};
}

}  // namespace rmpl::grammar
