// Instances: what is taken of every list goes behind what is there.
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

void append(Plant& to, const Plant& from, const PlantStretch& stretch, Renaming renamed) {
  const auto offset =
      static_cast<std::ptrdiff_t>(to.variables.size()) - static_cast<std::ptrdiff_t>(stretch.variables.begin);
  for (std::size_t v = stretch.variables.begin; v < stretch.variables.end; ++v) {
    const Variable& variable = from.variables[VariableId(v)];
    to.variables.add({renamed(variable.name), variable.values});
  }
  for (std::size_t c = stretch.components.begin; c < stretch.components.end; ++c) {
    Component& component = to.components.emplace_back(from.components[c]);
    component.name = renamed(component.name);
    shift(component.mode, offset);
    for (Mode& mode : component.modes) shift(mode.constraint, offset);
    for (Transition& transition : component.transitions) shift(transition.guard, offset);
  }
  for (std::size_t q = stretch.interconnections.begin; q < stretch.interconnections.end; ++q) {
    shift(to.interconnections.emplace_back(from.interconnections[q]).constraint, offset);
  }
  for (std::size_t c = stretch.controls.begin; c < stretch.controls.end; ++c) {
    shift(to.controls.emplace_back(from.controls[c]).variable, offset);
  }
  for (std::size_t o = stretch.observables.begin; o < stretch.observables.end; ++o) {
    shift(to.observables.emplace_back(from.observables[o]), offset);
  }
}

void instantiate(Plant& whole, std::string_view instance, const Plant& type) {
  const PlantStretch all{{0, type.variables.size()},
                         {0, type.components.size()},
                         {0, type.interconnections.size()},
                         {0, type.controls.size()},
                         {0, type.observables.size()}};
  append(whole, type, all, [&](const std::string& name) { return qualified(instance, name); });
}

}  // namespace rmpl::automata
