// What lint looks for in plants.
// SPDX-License-Identifier: MIT
#include <array>

#include "automata/software/software_in.hpp"
#include "compiler/lint/lint.hpp"
#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

namespace {

/// All findings about one plant share its abstraction, so they are one pass.
void lint_plant(const LintInput& input, const automata::Plant& plant, grammar::Diagnostics& found) {
  PlantReport report(input, plant, found);
  report_attributes(report);
  if (!report.analysis().is_possible()) return report_impossible_plant(report);
  report_modes(report);
  if (!report.analysis().reach().has_initial_state) return report_initial_state(report);
  report_guards(report);
  report_timers(report);
  report_duplicates(report);
  report_timed_faults(report);
  report_commands(report);
  report_sensing(report);
  report_readings(report);
  report_stuck(report);
  report_blocked_goals(report);
}

void lint_plants(const LintInput& input, grammar::Diagnostics& found) {
  for (std::size_t p = 0; p < input.document.plants.size(); ++p) {
    const automata::Plant& plant = input.document.plants[p];
    // What model programs tell is looked at as they stand.
    if (automata::is_software_alone(plant) || input.with_models.contains(p)) continue;
    if (input.places.has(plant.components.front().origin)) lint_plant(input, plant, found);
  }
}

}  // namespace

std::span<const LintPass> plant_passes() {
  static constexpr std::array passes = {LintPass{lint_plants}};
  return passes;
}

}  // namespace rmpl::compiler
