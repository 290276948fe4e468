// Declarations of model programs.
// SPDX-License-Identifier: MIT
#include "compiler/lower/model_declarations.hpp"

#include <unordered_map>

#include "base/overloaded.hpp"
#include "compiler/check/domains.hpp"
#include "compiler/check/resolve.hpp"
#include "compiler/lower/attributes.hpp"

namespace rmpl::compiler {

using automata::VariableId;
using grammar::Code;
using grammar::Name;

namespace {

/// The declared variables; of one whose domain is not known no more is said.
class DeclaredResolver final : public Resolver {
 public:
  DeclaredResolver(const Part& part, grammar::Diagnostics& diagnostics)
      : Resolver({part.plant.variables, &part.declared, "the model program", Code::unknown_name}, diagnostics),
        part_(part) {}

 protected:
  [[nodiscard]] bool lost_its_meaning(const Name& name) const override { return is_broken(part_, name.text); }
  automata::Formula clock(const grammar::ClockBound& bound) override {
    diagnostics().error(Code::clock_in_model, bound.clock.span,
                        "clock " + backquoted(bound.clock.text) + " in a model program, which counts steps");
    return automata::constant(true);
  }

 private:
  const Part& part_;
};

/// Calls one of the functions for each item of all files that it takes.
template <class... Functions>
void for_each_item(const std::vector<ProgramSource>& files, Functions... functions) {
  const base::Overloaded visit{functions..., [](const auto&) {}};
  for (const ProgramSource& source : files) {
    for (const grammar::ProgramItem& item : source.file->items) std::visit(visit, item);
  }
}

class Declaring {
 public:
  Declaring(const grammar::Sources& sources, const std::vector<ProgramSource>& files, grammar::Diagnostics& diagnostics)
      : sources_(sources), files_(files), diagnostics_(diagnostics) {}

  ModelDeclarations run() {
    Domains domains(diagnostics_);
    Uniqueness names("variable", diagnostics_);
    for_each_item(files_, [&](const grammar::Domain& domain) { domains.declare(domain); });
    for_each_item(files_, [&](const grammar::VariableDeclaration& v) {
      declare(made_.part, v.names, v.domain, names, domains, diagnostics_);
    });
    DeclaredResolver resolver(made_.part, diagnostics_);
    for_each_item(
        files_, [&](const grammar::Control& control) { add(control, resolver); },
        [&](const grammar::Observe& observe) {
          for (const Name& name : observe.names) {
            if (const auto id = fresh(name, "observed", observed_, resolver)) made_.observables.push_back(*id);
          }
        },
        [&](const grammar::StandingConstraint& standing) {
          made_.constraints.emplace_back(resolver.resolve(standing.constraint), origin_of(sources_, standing.span));
        });
    return std::move(made_);
  }

 private:
  using Places = std::unordered_map<VariableId, grammar::Span>;

  void add(const grammar::Control& control, Resolver& resolver) {
    for (const Name& name : control.names) {
      const auto id = fresh(name, "commanded", commanded_, resolver);
      if (!id) continue;
      std::optional<automata::ValueId> idle;
      if (control.idle) {
        if (const auto assignment = resolver.assignment(name, *control.idle)) idle = assignment->value;
      }
      made_.controls.push_back({*id, idle});
    }
  }

  /// The variable of a name that was not declared to be so before.
  std::optional<VariableId> fresh(const Name& name, const std::string& what, Places& known, Resolver& resolver) {
    const auto id = resolver.variable(name);
    if (!id) return std::nullopt;
    const auto [first, is_fresh] = known.emplace(*id, name.span);
    if (is_fresh) return id;
    auto& error = diagnostics_.error(Code::duplicate_name, name.span,
                                     backquoted(name.text) + " is already declared to be " + what);
    error.notes.push_back({first->second, "the first declaration is here"});
    return std::nullopt;
  }

  const grammar::Sources& sources_;
  const std::vector<ProgramSource>& files_;
  grammar::Diagnostics& diagnostics_;
  ModelDeclarations made_;
  Places commanded_, observed_;
};

}  // namespace

ModelDeclarations declare_model(const grammar::Sources& sources, const std::vector<ProgramSource>& files,
                                grammar::Diagnostics& diagnostics) {
  return Declaring(sources, files, diagnostics).run();
}

}  // namespace rmpl::compiler
