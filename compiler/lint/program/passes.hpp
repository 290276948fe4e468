// The passes over programs, scenarios and properties.
// SPDX-License-Identifier: MIT
#pragma once

#include "compiler/lint/lint.hpp"

namespace rmpl::compiler {

/// Conditions that never hold, always hold, or speak of what the plant cannot reach.
void lint_conditions(const LintInput& input, grammar::Diagnostics& found);
/// Goals that contradict each other in a cycle that can come about.
void lint_contradicting_goals(const LintInput& input, grammar::Diagnostics& found);
/// Steps of which what comes before never ends.
void lint_unreachable_steps(const LintInput& input, grammar::Diagnostics& found);
/// Goals on fault modes; goals that only a step reaches which nothing takes back.
void lint_fault_goals(const LintInput& input, grammar::Diagnostics& found);
void lint_irreversible_goals(const LintInput& input, grammar::Diagnostics& found);
/// Clocks started where a path may have started them.
void lint_clock_starts(const LintInput& input, grammar::Diagnostics& found);
/// Waits within what `whenever` or `always` starts anew while they last.
void lint_restarted_waits(const LintInput& input, grammar::Diagnostics& found);
/// What is asked of the executive's knowledge and can never be so, and surprises that nothing answers.
void lint_knowledge(const LintInput& input, grammar::Diagnostics& found);
/// What is there for nothing. Libraries, files without a plant or a start of a program, need not be used in whole.
void lint_unused_definitions(const LintInput& input, grammar::Diagnostics& found);
void lint_unused_parameters(const LintInput& input, grammar::Diagnostics& found);
void lint_unused_clocks(const LintInput& input, grammar::Diagnostics& found);
void lint_unused_domains(const LintInput& input, grammar::Diagnostics& found);
void lint_unused_types(const LintInput& input, grammar::Diagnostics& found);
/// Rules of scenarios that never come about; times that are less than a cycle.
void lint_rules(const LintInput& input, grammar::Diagnostics& found);
void lint_fine_times(const LintInput& input, grammar::Diagnostics& found);
/// Expectations that are met or fail whatever is flown; properties that hold or fail whatever the plant does.
void lint_vacuous_expectations(const LintInput& input, grammar::Diagnostics& found);
void lint_vacuous_properties(const LintInput& input, grammar::Diagnostics& found);
/// `,` and `;` in one pair of braces.
void lint_mixed_separators(const LintInput& input, grammar::Diagnostics& found);

}  // namespace rmpl::compiler
