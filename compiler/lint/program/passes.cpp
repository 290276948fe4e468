// What lint looks for in programs, scenarios and properties.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/passes.hpp"

#include <array>

#include "grammar/source/monitor_codes.hpp"

namespace rmpl::compiler {

using grammar::Code;
using grammar::Severity;

std::span<const LintPass> program_passes() {
  static constexpr std::array passes = {
      LintPass{&lint_conditions},        LintPass{&lint_contradicting_goals}, LintPass{&lint_unreachable_steps},
      LintPass{&lint_fault_goals},       LintPass{&lint_irreversible_goals},  LintPass{&lint_clock_starts},
      LintPass{&lint_restarted_waits},   LintPass{&lint_knowledge},           LintPass{&lint_unused_definitions},
      LintPass{&lint_unused_parameters}, LintPass{&lint_unused_clocks},       LintPass{&lint_unused_domains},
      LintPass{&lint_unused_types},      LintPass{&lint_mixed_separators},    LintPass{&lint_rules},
      LintPass{&lint_fine_times},        LintPass{&lint_vacuous_properties},  LintPass{&lint_vacuous_expectations},
  };
  return passes;
}

std::span<const LintCode> program_lint_codes() {
  static constexpr std::array codes = {
      LintCode{Code::requirement_twice, LintGroup::suspicious, Severity::warning},   // found by the compiler
      LintCode{Code::scenario_after_end, LintGroup::impossible, Severity::warning},  // found by the compiler
      LintCode{Code::condition_never_holds, LintGroup::impossible, Severity::warning},
      LintCode{Code::condition_always_holds, LintGroup::impossible, Severity::warning},
      LintCode{Code::condition_out_of_reach, LintGroup::impossible, Severity::warning},
      LintCode{Code::contradicting_goals, LintGroup::suspicious, Severity::warning},
      LintCode{Code::step_never_reached, LintGroup::impossible, Severity::warning},
      LintCode{Code::goal_on_fault_mode, LintGroup::suspicious, Severity::warning},
      LintCode{Code::irreversible_goal, LintGroup::suspicious, Severity::note},
      LintCode{Code::clock_started_twice, LintGroup::suspicious, Severity::warning},
      LintCode{Code::restarted_wait, LintGroup::suspicious, Severity::warning},
      LintCode{Code::knowledge_out_of_reach, LintGroup::impossible, Severity::warning},
      LintCode{Code::unanswered_surprise, LintGroup::suspicious, Severity::note},
      LintCode{Code::unused_definition, LintGroup::unused, Severity::warning},
      LintCode{Code::unused_parameter, LintGroup::unused, Severity::warning},
      LintCode{Code::unused_clock, LintGroup::unused, Severity::warning},
      LintCode{Code::unused_domain, LintGroup::unused, Severity::warning},
      LintCode{Code::unused_type, LintGroup::unused, Severity::warning},
      LintCode{Code::finer_than_cycle, LintGroup::timing, Severity::warning},
      LintCode{Code::vacuous_property, LintGroup::impossible, Severity::warning},
      LintCode{Code::rule_never_fires, LintGroup::impossible, Severity::warning},
      LintCode{Code::unused_allowance, LintGroup::allowance, Severity::warning},
      LintCode{Code::allowance_without_reason, LintGroup::allowance, Severity::warning},
      LintCode{Code::vacuous_expectation, LintGroup::impossible, Severity::warning},
      LintCode{grammar::monitor_gap, LintGroup::suspicious, Severity::warning},  // these by the compiler, too
      LintCode{grammar::monitor_hysteresis, LintGroup::suspicious, Severity::warning},
      LintCode{grammar::sample_without_reading, LintGroup::suspicious, Severity::warning},
      LintCode{grammar::monitor_value_missing, LintGroup::suspicious, Severity::note},
      LintCode{Code::mixed_separators, LintGroup::style, Severity::warning},
  };
  return codes;
}

}  // namespace rmpl::compiler
