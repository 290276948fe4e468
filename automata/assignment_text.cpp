// Assignments as people read them: `name = value`.
// SPDX-License-Identifier: MIT
#include "automata/assignment_text.hpp"

namespace rmpl::automata {
namespace {

std::string equation(const std::string& name, const std::string& value) { return name + " = " + value; }

}  // namespace

std::string to_text(const Variables& variables, const Assignment& assignment) {
  return equation(variables.name(assignment.variable), variables.value(assignment));
}

std::string to_text(const Variables& variables, std::span<const Assignment> assignments, std::string_view separator) {
  std::string text;
  for (const Assignment& assignment : assignments) {
    if (!text.empty()) text += separator;
    text += to_text(variables, assignment);
  }
  return text;
}

std::string to_text(const Component& component, ModeId mode) {
  return equation(component.name, component.modes[mode.index()].name);
}

}  // namespace rmpl::automata
