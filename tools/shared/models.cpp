// Reading what the command line names.
// SPDX-License-Identifier: MIT
#include "tools/shared/models.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "grammar/source/render.hpp"
#include "tools/shared/program.hpp"

namespace rmpl::tools {

void tell_findings(const grammar::Findings& findings, const Common& common) {
  if (findings.diagnostics.empty()) return;
  print_error(common.format == Format::json ? grammar::render_json(findings)
                                            : grammar::render_text(findings, error_painter(common.color).color));
}

compiler::Compilation load(const std::vector<std::string>& paths, const Common& common,
                           const compiler::Options& options) {
  check_standard_input(paths);
  compiler::Compilation compilation = compiler::compile(paths, options);
  if (!compilation.ok() || !common.quiet) tell_findings(compilation.findings(), common);
  if (!compilation.ok()) throw Rejected{};
  compilation.forget_files();
  return compilation;
}

namespace {

/// The only one of some things in an input.
template <class Things>
const auto& only(const Things& things, const automata::Document& document, const std::string& paths, const char* what,
                 const char* ending) {
  if (things.size() == 1) return things.front();
  const std::string expected = std::string("expected one ") + what + ", as in a " + ending + " file";
  if (things.empty() && !document.models.empty()) {
    throw base::InputError(paths + ": " + expected + ", and '" + document.models.front().name +
                           "' is, or holds, a model program, which rmpl-run estimate, diagnose, scenario and "
                           "execute, tcca-check reachability and safety take");
  }
  if (things.empty()) throw base::InputError(paths + ": " + expected + ", and there is none in it");
  throw base::InputError(paths + ": " + expected + ", and there are " + std::to_string(things.size()));
}

}  // namespace

const automata::Plant& only_plant(const automata::Document& document, const std::string& paths) {
  return only(document.plants, document, paths, "plant", ".tcca");
}

const automata::Program& only_program(const automata::Document& document, const std::string& paths) {
  return only(document.programs, document, paths, "control program", ".rmpl");
}

const automata::ModelProgram& only_model_program(const automata::Document& document, const std::string& paths) {
  return only(document.models, document, paths, "model program", ".rmpl");
}

bool is_model_program(const automata::Document& document) {
  return document.plants.empty() && !document.models.empty();
}

const automata::Plant& only_controlled_plant(const automata::Document& document, const std::string& paths) {
  if (!is_model_program(document)) return only_plant(document, paths);
  const automata::ModelProgram& program = only_model_program(document, paths);
  const auto facade = document.facades.find(0);
  if (facade != document.facades.end()) return facade->second;
  throw base::InputError(paths + ": expected every control of '" + program.name + "' to have a default");
}

void refuse_start(const automata::ModelProgram& program, const std::string& paths) {
  throw base::InputError(paths + ": no start is consistent: what the start locations of '" + program.name +
                         "' tell contradicts itself, or the constraints for the whole model");
}

namespace {

template <class Model>
automata::Formula formula_over(const std::string& text, const Model& model, std::string_view where,
                               const Common& common) {
  auto compiled = compiler::compile_formula(text, model, where);
  tell_findings(compiled.findings, common);
  if (!compiled.formula) throw Rejected{};
  return std::move(*compiled.formula);
}

}  // namespace

automata::Formula formula_option(const std::string& text, const automata::Plant& plant, std::string_view where,
                                 const Common& common) {
  return formula_over(text, plant, where, common);
}

automata::Formula formula_option(const std::string& text, const automata::ModelProgram& program, std::string_view where,
                                 const Common& common) {
  return formula_over(text, program, where, common);
}

namespace {

template <class Model>
std::vector<automata::Assignment> assignments_over(const std::string& text, const Model& model, std::string_view where,
                                                   const Common& common) {
  auto compiled = compiler::compile_assignments(text, model, where);
  tell_findings(compiled.findings, common);
  if (!compiled.assignments) throw Rejected{};
  std::vector<automata::Assignment> assignments = std::move(*compiled.assignments);
  std::sort(assignments.begin(), assignments.end());
  assignments.erase(std::unique(assignments.begin(), assignments.end()), assignments.end());
  const auto twice = std::adjacent_find(assignments.begin(), assignments.end(),
                                        [](const auto& a, const auto& b) { return a.variable == b.variable; });
  if (twice != assignments.end()) {
    throw base::InputError(std::string(where) + ": '" + model.variables.name(twice->variable) +
                           "' is given two values, '" + model.variables.value(*twice) + "' and '" +
                           model.variables.value(*(twice + 1)) + "'");
  }
  return assignments;
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
