// What lint looks for in plants.
// SPDX-License-Identifier: MIT
#include <array>

#include "compiler/lint/lint.hpp"

namespace rmpl::compiler {

using grammar::Code;
using grammar::Severity;

std::span<const LintPass> plant_passes() { return {}; }

std::span<const LintCode> plant_lint_codes() {
  static constexpr std::array codes = {
      LintCode{Code::duplicate_transition, LintGroup::suspicious, Severity::warning},  // found by the compiler
  };
  return codes;
}

}  // namespace rmpl::compiler
