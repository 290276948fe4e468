// What lint looks for in programs, scenarios and properties.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program_passes.hpp"

#include <array>

namespace rmpl::compiler {

using grammar::Code;
using grammar::Severity;

std::span<const LintPass> program_passes() {
  static constexpr std::array passes = {
      LintPass{&lint_mixed_separators},
  };
  return passes;
}

std::span<const LintCode> program_lint_codes() {
  static constexpr std::array codes = {
      LintCode{Code::scenario_after_end, LintGroup::impossible, Severity::warning},  // found by the compiler
      LintCode{Code::mixed_separators, LintGroup::style, Severity::warning},
  };
  return codes;
}

}  // namespace rmpl::compiler
