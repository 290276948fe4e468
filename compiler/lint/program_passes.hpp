// The passes over programs, scenarios and properties.
// SPDX-License-Identifier: MIT
#pragma once

#include "compiler/lint/lint.hpp"

namespace rmpl::compiler {

/// `,` and `;` in one pair of braces.
void lint_mixed_separators(const LintInput& input, grammar::Diagnostics& found);

}  // namespace rmpl::compiler
