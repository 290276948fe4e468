// What lint looks for in programs, scenarios and properties.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/passes.hpp"

#include <array>

namespace rmpl::compiler {

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

}  // namespace rmpl::compiler
