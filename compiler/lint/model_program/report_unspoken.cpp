// Told: variables that nothing speaks of, and readings that say nothing.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <string>
#include <variant>

#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/model_program/report.hpp"

namespace rmpl::compiler {

using automata::VariableId;

namespace {

void collect(const automata::Formula& formula, std::set<VariableId>& variables) {
  for (const VariableId v : variables_of(formula)) variables.insert(v);
}

/// The variables of all that is told, stands or is asked.
std::set<VariableId> mentioned(const ModelReport& report) {
  std::set<VariableId> variables;
  for (const automata::Interconnection& standing : report.program().constraints)
    collect(standing.constraint, variables);
  for (const automata::ModelLocation& location : report.program().locations) collect(location.told, variables);
  for (const PlacedCondition& condition : report.places().conditions) collect(condition.formula, variables);
  return variables;
}

/// What a variable is there for; nothing where it is neither commanded nor seen.
const char* use_of(const automata::ModelProgram& program, VariableId variable) {
  const auto is = [&](const automata::CommandedVariable& control) { return control.variable == variable; };
  if (std::any_of(program.controls.begin(), program.controls.end(), is)) return ": its commands have no effect";
  const auto& seen = program.observables;
  return std::find(seen.begin(), seen.end(), variable) != seen.end() ? ": its readings carry no information" : "";
}

}  // namespace

void report_unspoken(ModelReport& report) {
  const std::set<VariableId> spoken_of = mentioned(report);
  for (const File& file : report.input().files) {
    if (!file.program) continue;
    for (const grammar::ProgramItem& item : file.program->items) {
      const auto* declaration = std::get_if<grammar::VariableDeclaration>(&item);
      if (declaration == nullptr) continue;
      for (const grammar::Name& name : declaration->names) {
        const auto variable = report.program().variables.find(name.text);
        if (!variable || spoken_of.count(*variable) > 0) continue;
        report.add(grammar::Code::unused_attribute, name.span,
                   "no constraint and no condition mentions variable " + backquoted(name.text) +
                       use_of(report.program(), *variable));
      }
    }
  }
}

}  // namespace rmpl::compiler
