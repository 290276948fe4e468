// Instances: every list of the type goes behind that of the whole.
// SPDX-License-Identifier: MIT
#include "automata/instance.hpp"

namespace rmpl::automata {

std::string qualified(std::string_view instance, std::string_view name) {
  if (name.empty()) return std::string(instance);
  return std::string(instance) + "." + std::string(name);
}

void shift(VariableId& id, std::ptrdiff_t offset) {
  id = VariableId(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(id.index()) + offset));
}

void shift(Formula& formula, std::ptrdiff_t offset) {
  if (formula.kind == Formula::Kind::member || formula.kind == Formula::Kind::equality) shift(formula.variable, offset);
  if (formula.kind == Formula::Kind::equality) shift(formula.other, offset);
  for (Formula& operand : formula.operands) shift(operand, offset);
}

void instantiate(Plant& whole, std::string_view instance, const Plant& type) {
  const auto offset = static_cast<std::ptrdiff_t>(whole.variables.size());
  for (const Variable& variable : type.variables) {
    whole.variables.add({qualified(instance, variable.name), variable.values});
  }
  for (const Component& component : type.components) {
    Component& copy = whole.components.emplace_back(component);
    copy.name = qualified(instance, component.name);
    shift(copy.mode, offset);
    for (Mode& mode : copy.modes) shift(mode.constraint, offset);
    for (Transition& transition : copy.transitions) shift(transition.guard, offset);
  }
  for (const Interconnection& interconnection : type.interconnections) {
    shift(whole.interconnections.emplace_back(interconnection).constraint, offset);
  }
  for (const Control& control : type.controls) {
    shift(whole.controls.emplace_back(control).variable, offset);
  }
  for (const VariableId observable : type.observables) shift(whole.observables.emplace_back(observable), offset);
}

}  // namespace rmpl::automata
