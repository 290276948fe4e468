// Instances: copies of a part under a name.
// SPDX-License-Identifier: MIT
#include "compiler/lower/part.hpp"

#include "automata/instance.hpp"

namespace rmpl::compiler {

using automata::qualified;

namespace {

void shift(std::vector<automata::GuardedArc>& arcs, std::ptrdiff_t offset) {
  for (automata::GuardedArc& arc : arcs) {
    for (automata::Condition& guard : arc.guard) shift(guard.constraint, offset);
  }
}

void shift(automata::ModelProgram& program, std::ptrdiff_t offset) {
  for (automata::ModelLocation& location : program.locations) {
    shift(location.told, offset);
    shift(location.maintenance.constraint, offset);
    shift(location.arcs, offset);
    for (automata::TransitionFunction& function : location.functions) shift(function.arcs, offset);
  }
}

}  // namespace

bool make_room(Part& part, std::size_t more, grammar::Span blame, grammar::Diagnostics& diagnostics) {
  if (part.size > size_limit) return false;
  part.size += more;
  if (part.size <= size_limit) return true;
  diagnostics.error(grammar::Code::too_large, blame,
                    "the model grows beyond " + std::to_string(size_limit) + " values, modes and transitions here");
  return false;
}

void instantiate(Part& whole, const std::string& instance, const Part& type) {
  const auto offset = static_cast<std::ptrdiff_t>(whole.plant.variables.size());
  automata::instantiate(whole.plant, instance, type.plant);
  whole.declared.insert(whole.declared.end(), type.declared.begin(), type.declared.end());
  for (const ModelPart& model : type.models) {
    ModelPart& copy = whole.models.emplace_back(model);
    copy.component.name = qualified(instance, model.component.name);
    shift(copy.component.program, offset);
    for (PlacedCondition& condition : copy.conditions) shift(condition.formula, offset);
  }
  for (const std::string& name : type.broken) whole.broken.insert(qualified(instance, name));
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
