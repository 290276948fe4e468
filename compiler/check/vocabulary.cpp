// Names in messages: lists of them, and the nearest to a misspelled one.
// SPDX-License-Identifier: MIT
#include "compiler/check/vocabulary.hpp"

#include "base/enumerated.hpp"
#include "base/nearest.hpp"

namespace rmpl::compiler {

using automata::ValueId;
using automata::VariableId;

std::optional<grammar::Span> Vocabulary::declaration(VariableId id) const {
  if (declared == nullptr || id.index() >= declared->size()) return std::nullopt;
  return (*declared)[id.index()];
}

std::vector<ValueId> Vocabulary::meant(VariableId variable, ValueId value) const {
  std::vector<ValueId> result{value};
  for (const automata::Component* component : software) {
    if (component->mode != variable) continue;
    for (std::size_t m = 0; m < component->modes.size(); ++m) {
      if (component->modes[m].usual == automata::ModeId(value.index())) result.emplace_back(m);
    }
  }
  return result;
}

std::vector<const automata::Component*> software_of(const automata::Plant& plant) {
  std::vector<const automata::Component*> result;
  for (const automata::Component& component : plant.components) {
    if (component.software) result.push_back(&component);
  }
  return result;
}

std::string backquoted(std::string_view name) { return "`" + std::string(name) + "`"; }

std::string one_of(const std::vector<std::string>& names) {
  constexpr std::size_t shown = 8;
  std::vector<std::string> quoted;
  for (std::size_t i = 0; i < names.size() && i < shown; ++i) quoted.push_back(backquoted(names[i]));
  if (names.size() > shown) quoted.push_back("one of " + std::to_string(names.size() - shown) + " more");
  return base::enumerated(quoted, "or");
}

void suggest(grammar::Diagnostic& diagnostic, std::size_t errors_so_far, std::string_view name,
             const std::vector<std::string>& candidates) {
  constexpr std::size_t patience = 50;
  if (errors_so_far > patience) return;
  const auto near = base::nearest(name, candidates);
  if (!near) return;
  diagnostic.suggestion = "did you mean " + backquoted(*near) + "?";
  // Only where the name itself is blamed: an argument of a call may be blamed for what it stands for.
  if (diagnostic.span.end - diagnostic.span.begin == name.size()) diagnostic.fix = {{diagnostic.span, *near}};
}

std::vector<std::string> names_of(const automata::Variables& variables) {
  std::vector<std::string> names;
  for (const automata::Variable& variable : variables) {
    if (!variable.name.empty()) names.push_back(variable.name);
  }
  return names;
}

}  // namespace rmpl::compiler
