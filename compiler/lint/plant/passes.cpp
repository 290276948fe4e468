// What lint looks for in plants.
// SPDX-License-Identifier: MIT
#include <array>

#include "compiler/lint/lint.hpp"
#include "compiler/lint/plant/report.hpp"

namespace rmpl::compiler {

using grammar::Code;
using grammar::Severity;

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
  for (const automata::Plant& plant : input.document.plants) {
    if (!plant.components.empty() && input.places.has(plant.components.front().origin)) lint_plant(input, plant, found);
  }
}

}  // namespace

std::span<const LintPass> plant_passes() {
  static constexpr std::array passes = {LintPass{lint_plants}};
  return passes;
}

std::span<const LintCode> plant_lint_codes() {
  static constexpr std::array codes = {
      LintCode{Code::duplicate_transition, LintGroup::suspicious, Severity::warning},  // found by the compiler
      LintCode{Code::unreachable_mode, LintGroup::impossible, Severity::warning},
      LintCode{Code::impossible_guard, LintGroup::impossible, Severity::warning},
      LintCode{Code::impossible_mode, LintGroup::impossible, Severity::warning},
      LintCode{Code::overlapping_guards, LintGroup::suspicious, Severity::warning},
      LintCode{Code::shadowed_transition, LintGroup::impossible, Severity::warning},
      LintCode{Code::no_initial_state, LintGroup::impossible, Severity::warning},
      LintCode{Code::impossible_initial_mode, LintGroup::impossible, Severity::warning},
      LintCode{Code::stuck_plant, LintGroup::impossible, Severity::warning},
      LintCode{Code::contradictory_interconnections, LintGroup::impossible, Severity::warning},
      LintCode{Code::impossible_command, LintGroup::impossible, Severity::warning},
      LintCode{Code::uncommanded_component, LintGroup::suspicious, Severity::note},
      LintCode{Code::undetectable_fault, LintGroup::observability, Severity::note},
      LintCode{Code::indistinguishable_faults, LintGroup::observability, Severity::note},
      LintCode{Code::indistinguishable_modes, LintGroup::observability, Severity::note},
      LintCode{Code::unconnected_input, LintGroup::suspicious, Severity::warning},
      LintCode{Code::unread_command, LintGroup::unused, Severity::warning},
      LintCode{Code::unused_attribute, LintGroup::unused, Severity::warning},
      LintCode{Code::timed_fault, LintGroup::timing, Severity::warning},
      LintCode{Code::late_guard, LintGroup::timing, Severity::warning},
      LintCode{Code::timer_goes_on, LintGroup::timing, Severity::note},
      LintCode{Code::unexplained_reading, LintGroup::observability, Severity::note},
      LintCode{Code::fault_blocks_goal, LintGroup::suspicious, Severity::note},
      LintCode{Code::idle_transition, LintGroup::suspicious, Severity::warning},
      LintCode{Code::unused_weight, LintGroup::suspicious, Severity::warning},
      LintCode{Code::unobserved_plant, LintGroup::observability, Severity::note},
  };
  return codes;
}

}  // namespace rmpl::compiler
