// Instances: copies of a part under a name.
// SPDX-License-Identifier: MIT
#include "compiler/lower/part.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::VariableId;

namespace {

/// Moves every variable of a formula by `offset`; domains stay as they are.
void shift(Formula& formula, std::size_t offset) {
  const auto move = [offset](VariableId& id) { id = VariableId(id.index() + offset); };
  if (formula.kind == Formula::Kind::member || formula.kind == Formula::Kind::equality) move(formula.variable);
  if (formula.kind == Formula::Kind::equality) move(formula.other);
  for (Formula& operand : formula.operands) shift(operand, offset);
}

void shift(std::vector<automata::GuardedArc>& arcs, std::size_t offset) {
  for (automata::GuardedArc& arc : arcs) {
    for (automata::Condition& guard : arc.guard) shift(guard.constraint, offset);
  }
}

void shift(automata::ModelProgram& program, std::size_t offset) {
  for (automata::ModelLocation& location : program.locations) {
    shift(location.told, offset);
    shift(location.maintenance.constraint, offset);
    shift(location.arcs, offset);
    for (automata::TransitionFunction& function : location.functions) shift(function.arcs, offset);
  }
}

}  // namespace

std::string qualified(std::string_view instance, std::string_view name) {
  if (name.empty()) return std::string(instance);
  return std::string(instance) + "." + std::string(name);
}

bool make_room(Part& part, std::size_t more, grammar::Span blame, grammar::Diagnostics& diagnostics) {
  if (part.size > size_limit) return false;
  part.size += more;
  if (part.size <= size_limit) return true;
  diagnostics.error(grammar::Code::too_large, blame,
                    "the model grows beyond " + std::to_string(size_limit) + " values, modes and transitions here");
  return false;
}

void instantiate(Part& whole, const std::string& instance, const Part& type) {
  automata::Plant& plant = whole.plant;
  const std::size_t offset = plant.variables.size();
  for (const automata::Variable& variable : type.plant.variables) {
    plant.variables.add({qualified(instance, variable.name), variable.values});
  }
  whole.declared.insert(whole.declared.end(), type.declared.begin(), type.declared.end());
  for (const automata::Component& component : type.plant.components) {
    automata::Component& copy = plant.components.emplace_back(component);
    copy.name = qualified(instance, component.name);
    copy.mode = VariableId(component.mode.index() + offset);
    for (automata::Mode& mode : copy.modes) shift(mode.constraint, offset);
    for (automata::Transition& transition : copy.transitions) shift(transition.guard, offset);
  }
  for (const automata::Interconnection& interconnection : type.plant.interconnections) {
    shift(plant.interconnections.emplace_back(interconnection).constraint, offset);
  }
  for (const automata::Control& control : type.plant.controls) {
    plant.controls.push_back({VariableId(control.variable.index() + offset), control.idle});
  }
  for (const ModelPart& model : type.models) {
    ModelPart& copy = whole.models.emplace_back(model);
    copy.component.name = qualified(instance, model.component.name);
    shift(copy.component.program, offset);
    for (PlacedCondition& condition : copy.conditions) shift(condition.formula, offset);
  }
  for (const std::string& name : type.broken) whole.broken.insert(qualified(instance, name));
  for (const VariableId observable : type.plant.observables) {
    plant.observables.emplace_back(observable.index() + offset);
  }
}

std::string first_clash(const Part& whole, const std::string& instance, const Part& type) {
  for (const automata::Variable& variable : type.plant.variables) {
    std::string name = qualified(instance, variable.name);
    if (whole.plant.variables.find(name)) return name;
  }
  return {};
}

bool is_broken(const Part& part, std::string_view name) {
  if (part.broken.empty()) return false;
  for (std::size_t dot = name.find('.'); dot != std::string_view::npos; dot = name.find('.', dot + 1)) {
    if (part.broken.contains(name.substr(0, dot))) return true;
  }
  return part.broken.contains(name);
}

automata::Origin origin_of(const grammar::Sources& sources, grammar::Span span) {
  const grammar::SourceFile& file = sources[span.file];
  const grammar::Place place = file.place(span.begin);
  return {file.name(), place.line, place.column};
}

}  // namespace rmpl::compiler
