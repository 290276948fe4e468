// Interconnections, control variables and observables of a module.
// SPDX-License-Identifier: MIT
#include "compiler/lower/ports.hpp"

#include <unordered_map>
#include <unordered_set>

#include "compiler/check/resolve.hpp"

namespace rmpl::compiler {

using automata::VariableId;
using grammar::Code;
using grammar::Name;

namespace {

/// The names of a part; of one that an error left without meaning no more is said.
class PartResolver final : public Resolver {
 public:
  PartResolver(const Vocabulary& vocabulary, const Part& part, grammar::Diagnostics& diagnostics)
      : Resolver(vocabulary, diagnostics), part_(part) {}

 protected:
  [[nodiscard]] bool lost_its_meaning(const Name& name) const override { return is_broken(part_, name.text); }

 private:
  const Part& part_;
};

class Connector {
 public:
  Connector(const grammar::Sources& sources, const grammar::ModuleDefinition& definition, Part& part,
            grammar::Diagnostics& diagnostics)
      : sources_(sources),
        definition_(definition),
        part_(part),
        diagnostics_(diagnostics),
        resolver_({part.plant.variables, &part.declared,
                   (definition.plant ? "plant " : "module ") + backquoted(definition.name.text), Code::unknown_name},
                  part, diagnostics) {
    for (const automata::Component& component : part.plant.components) modes_.insert(component.mode);
    for (const automata::Control& control : part.plant.controls) controls_.emplace(control.variable, std::nullopt);
    for (const VariableId observable : part.plant.observables) observables_.emplace(observable, std::nullopt);
  }

  void run() {
    for (const grammar::ModuleItem& item : definition_.items) {
      if (const auto* connection = std::get_if<grammar::Interconnection>(&item)) {
        part_.plant.interconnections.emplace_back(resolver_.resolve(connection->constraint),
                                                  origin_of(sources_, connection->span));
      } else if (const auto* control = std::get_if<grammar::Control>(&item)) {
        add(*control);
      } else if (const auto* observe = std::get_if<grammar::Observe>(&item)) {
        for (const Name& name : observe->names) {
          if (const auto id = attribute(name, "observable", observables_)) part_.plant.observables.push_back(*id);
        }
      }
    }
  }

 private:
  using Places = std::unordered_map<VariableId, std::optional<grammar::Span>>;

  void add(const grammar::Control& control) {
    if (!control.idle) {
      auto& error = diagnostics_.error(Code::no_default, control.span,
                                       "control " + backquoted(control.names.front().text) + " has no idle value");
      error.suggestion = "add `default` and the value that commands nothing";
    }
    for (const Name& name : control.names) {
      const auto id = attribute(name, "control variable", controls_);
      if (!id || !control.idle) continue;
      if (const auto idle = resolver_.assignment(name, *control.idle))
        part_.plant.controls.push_back({*id, idle->value});
    }
  }

  /// The variable of a name that must be an attribute, and new to `known`.
  std::optional<VariableId> attribute(const Name& name, const std::string& kind, Places& known) {
    const auto id = resolver_.variable(name);
    if (!id) return std::nullopt;
    if (modes_.count(*id) != 0) {
      auto& error = diagnostics_.error(
          Code::wrong_kind_of_name, name.span,
          backquoted(name.text) + " is a component, and a mode is not a possible " + kind + ": expected an attribute");
      error.suggestion = "name one of its attributes, as in `" + name.text + ".…`";
      return std::nullopt;
    }
    const auto [first, fresh] = known.emplace(*id, name.span);
    if (fresh) return id;
    auto& error = diagnostics_.error(
        Code::duplicate_name, name.span,
        backquoted(name.text) + " is already declared to be " + (kind == "observable" ? "an " : "a ") + kind);
    if (first->second) error.notes.push_back({*first->second, "the first declaration is here"});
    return std::nullopt;
  }

  const grammar::Sources& sources_;
  const grammar::ModuleDefinition& definition_;
  Part& part_;
  grammar::Diagnostics& diagnostics_;
  PartResolver resolver_;
  std::unordered_set<VariableId> modes_;
  Places controls_;     ///< with the place of the declaration, unless a module within has made it
  Places observables_;  ///< likewise
};

}  // namespace

void connect(const grammar::Sources& sources, const grammar::ModuleDefinition& definition, Part& part,
             grammar::Diagnostics& diagnostics) {
  Connector(sources, definition, part, diagnostics).run();
}

}  // namespace rmpl::compiler
