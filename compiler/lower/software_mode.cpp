// Modes of software by what they tell.
// SPDX-License-Identifier: MIT
#include "compiler/lower/software_mode.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "automata/fault_step.hpp"
#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using automata::Assignment;

std::vector<Assignment> modes_that_tell(const automata::Plant& plant, Assignment told, SoftwareMoment moment) {
  std::vector<Assignment> result, others;
  const automata::Formula wanted = automata::is(told.variable, told.value);
  for (const automata::Component& component : plant.components) {
    if (!component.software) continue;
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const bool meant = moment == SoftwareMoment::start ? component.initial[m] > 0 : component.modes[m].fault;
      if (!meant) continue;
      const std::vector<automata::Formula> parts = automata::conjuncts_of(component.modes[m].constraint);
      if (std::find(parts.begin(), parts.end(), wanted) == parts.end()) continue;
      if (automata::is_second_in_a_row(component, automata::ModeId(m))) continue;
      (component.modes[m].usual ? others : result).push_back({component.mode, automata::ValueId(m)});
    }
  }
  return result.empty() ? others : result;
}

void report_several(const Part& part, Assignment told, const std::vector<Assignment>& telling, grammar::Span span,
                    grammar::Diagnostics& diagnostics) {
  const automata::Variables& variables = part.plant.variables;
  std::vector<std::string> names;
  names.reserve(telling.size());
  for (const Assignment& one : telling) names.push_back(variables.name(one.variable) + " = " + variables.value(one));
  auto& error = diagnostics.error(grammar::Code::scenario_not_a_mode, span,
                                  std::to_string(telling.size()) + " modes of software tell that " +
                                      backquoted(variables.name(told.variable)) + " is " +
                                      backquoted(variables.value(told)) + ", expected one of them");
  error.suggestion = "name the mode: " + one_of(names);
}

}  // namespace rmpl::compiler
