// What lint looks for in model programs: all findings about one share what may be told and marked.
// SPDX-License-Identifier: MIT
#include <array>

#include "compiler/lint/lint.hpp"
#include "compiler/lint/model_program/report.hpp"
#include "compiler/lint/model_program/told_program.hpp"

namespace rmpl::compiler {

namespace {

void lint_model_programs(const LintInput& input, grammar::Diagnostics& found) {
  MarkedSpans marked;
  for (std::size_t m = 0; m < input.document.models.size(); ++m) {
    ModelReport report(input, input.document.models[m], input.models[m], found);
    if (!report.name()) continue;
    if (!report_start(report)) continue;
    report_conditions(report);
    report_contradictions(report);
    report_unspoken(report);
    add_marked(report, marked);
  }
  for (const auto& [position, whole] : input.with_models) {
    const automata::ModelProgram program = told_program(whole);
    ModelReport report(input, program, input.software.at(position), found);
    if (report.name() && report_start(report)) report_conditions(report);
  }
  report_unreached_steps(input, marked, found);
}

}  // namespace

std::span<const LintPass> model_program_passes() {
  static constexpr std::array passes = {LintPass{lint_model_programs}};
  return passes;
}

}  // namespace rmpl::compiler
