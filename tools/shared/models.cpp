// Reading what the command line names.
// SPDX-License-Identifier: MIT
#include "tools/shared/models.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "grammar/source/render.hpp"
#include "tools/shared/program.hpp"

namespace rmpl::tools {

void tell_findings(const grammar::Findings& findings, const Common& common) {
  if (findings.diagnostics.empty()) return;
  print_error(common.format == Format::json ? base::printable_json(grammar::render_json(findings))
                                            : grammar::render_text(findings, error_painter(common.color).color));
}

compiler::Compilation load(const std::vector<std::string>& paths, const Common& common,
                           const compiler::Options& options) {
  check_standard_input(paths);
  compiler::Compilation compilation = compiler::compile(paths, options);
  if (!compilation.ok() || !common.quiet) tell_findings(compilation.findings(), common);
  if (!compilation.ok()) throw Rejected{grammar::render_text(compilation.findings(), false)};
  compilation.forget_files();
  return compilation;
}

namespace {

automata::Formula formula_of(compiler::CompiledFormula compiled, const Common& common) {
  tell_findings(compiled.findings, common);
  if (!compiled.formula) throw Rejected{grammar::render_text(compiled.findings, false)};
  return std::move(*compiled.formula);
}

}  // namespace

automata::Formula formula_option(const std::string& text, const automata::Plant& plant, std::string_view where,
                                 const Common& common) {
  return formula_of(compiler::compile_formula(text, plant, where), common);
}

automata::Formula program_formula_option(const std::string& text, const automata::Plant& plant, std::string_view where,
                                         const Common& common) {
  return formula_of(compiler::compile_program_formula(text, plant, where), common);
}

automata::Formula goal_option(const std::string& text, const automata::Plant& plant, std::string_view where,
                              const Common& common) {
  return formula_of(compiler::compile_goal(text, plant, where), common);
}

automata::Formula formula_option(const std::string& text, const automata::ModelProgram& program, std::string_view where,
                                 const Common& common) {
  return formula_of(compiler::compile_formula(text, program, where), common);
}

namespace {

template <class Model>
std::vector<automata::Assignment> assignments_over(const std::string& text, const Model& model, std::string_view where,
                                                   const Common& common) {
  auto compiled = compiler::compile_assignments(text, model, where);
  tell_findings(compiled.findings, common);
  if (!compiled.assignments) throw Rejected{grammar::render_text(compiled.findings, false)};
  return compiler::each_once(std::move(*compiled.assignments), model.variables, where);
}

}  // namespace

std::vector<automata::Assignment> assignments_option(const std::string& text, const automata::Plant& plant,
                                                     std::string_view where, const Common& common) {
  return assignments_over(text, plant, where, common);
}

std::vector<automata::Assignment> assignments_option(const std::string& text, const automata::ModelProgram& program,
                                                     std::string_view where, const Common& common) {
  return assignments_over(text, program, where, common);
}

void check_standard_input(const std::vector<std::string>& paths) {
  if (std::count(paths.begin(), paths.end(), "-") > 1) {
    throw base::InputError("'-' stands for standard input, which can be read only once");
  }
}

}  // namespace rmpl::tools
