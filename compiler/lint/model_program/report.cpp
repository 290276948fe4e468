// What the findings about a model program have in common.
// SPDX-License-Identifier: MIT
#include "compiler/lint/model_program/report.hpp"

#include <string>
#include <utility>
#include <variant>

#include "compiler/check/vocabulary.hpp"

namespace rmpl::compiler {

using automata::LocationId;

const std::vector<bool>& ModelReport::reachable() {
  if (reachable_.empty()) reachable_ = reachable_locations(program_, stores_);
  return reachable_;
}

grammar::Span ModelReport::span_of(LocationId location) const {
  return places_.locations.empty() ? input_.places.at(program_.locations[location.index()].origin)
                                   : places_.locations[location.index()];
}

std::optional<grammar::Span> ModelReport::name() const {
  if (!places_.locations.empty()) return places_.locations.front();
  for (const File& file : input_.files) {
    if (!file.plant) continue;
    for (const grammar::PlantItem& item : file.plant->items) {
      const auto* module = std::get_if<grammar::ModuleDefinition>(&item);
      if (module != nullptr && module->plant && module->name.text == program_.name) return module->name.span;
    }
  }
  return std::nullopt;
}

grammar::Diagnostic& ModelReport::add(grammar::Code code, grammar::Span span, std::string message) {
  return add_finding(found_, code, span, std::move(message));
}

void ModelReport::blame(grammar::Diagnostic& finding, const ToldContradiction& contradiction) const {
  for (const LocationId l : contradiction.told) {
    const std::string told = to_text(program_.locations[l.index()].told, program_.variables);
    finding.notes.push_back({span_of(l), backquoted(told) + " is told here"});
  }
  for (const std::size_t standing : contradiction.standing) {
    finding.notes.push_back({input_.places.at(program_.constraints[standing].origin), "this constraint always holds"});
  }
}

void add_marked(ModelReport& report, MarkedSpans& marked) {
  for (std::size_t l = 0; l < report.program().locations.size(); ++l) {
    bool& may_be = marked[report.span_of(LocationId(l))];
    may_be = may_be || report.reachable()[l];
  }
}

}  // namespace rmpl::compiler
