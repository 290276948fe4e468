// Definitions, parameters, clocks, domains and types that are there for nothing.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/overloaded.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/program/bound_programs.hpp"
#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/removal.hpp"
#include "compiler/lint/tree_walk.hpp"

namespace rmpl::compiler {

using grammar::Code;
using grammar::Definition;
using grammar::Name;
using grammar::Span;

namespace {

/// How often each declaration is mentioned, itself included.
std::map<Span, std::size_t> mentions_of(const LintInput& input) {
  std::map<Span, std::size_t> count;
  for (const Mention& mention : input.names.all()) ++count[mention.declaration];
  return count;
}

std::vector<std::string_view> calls_in(const Definition& definition) {
  std::vector<std::string_view> calls;
  const base::Overloaded visit{[](const grammar::Body&) {},
                               [&](const grammar::Step& step) {
                                 const auto* call = std::get_if<grammar::Call>(&step.node);
                                 if (call != nullptr) calls.push_back(call->definition.text);
                               }};
  for_each_step(definition.body, visit);
  return calls;
}

/// The names of clocks that a constraint reads.
void collect_reads(const grammar::Constraint& constraint, std::set<std::string_view>& reads) {
  std::visit(base::Overloaded{[&](const grammar::ClockBound& bound) { reads.insert(bound.clock.text); },
                              [](const grammar::Truth&) {}, [](const grammar::Reference&) {},
                              [](const grammar::Comparison&) {}, [](const grammar::Membership&) {},
                              [&](const auto& connective) {
                                for (const auto& operand : connective.operands) collect_reads(operand, reads);
                              }},
             constraint.node);
}

/// What a definition does with clocks. What is passed on to another definition counts as read.
struct ClockUse {
  std::vector<Name> starts;
  std::set<std::string_view> reads;
};

ClockUse clocks_in(const Definition& definition) {
  ClockUse use;
  const base::Overloaded inside{[](const grammar::Goal&) {},
                                [&](const grammar::ClockStart& start) { use.starts.push_back(start.clock); },
                                [&](const grammar::Call& call) {
                                  for (const grammar::Argument& argument : call.arguments) {
                                    if (const auto* name = std::get_if<Name>(&argument.node))
                                      use.reads.insert(name->text);
                                    if (const auto* constraint = std::get_if<grammar::Constraint>(&argument.node)) {
                                      collect_reads(*constraint, use.reads);
                                    }
                                  }
                                },
                                [](const grammar::Block&) {},
                                [](const grammar::Nothing&) {},
                                [](const grammar::Each&) {},
                                [](const grammar::Repeat&) {},
                                [](const grammar::Always&) {},
                                [](const grammar::Next&) {},
                                [](const grammar::Choose&) {},
                                [&](const auto& conditional) { collect_reads(conditional.condition, use.reads); }};
  const base::Overloaded visit{[](const grammar::Body&) {},
                               [&](const grammar::Step& step) { std::visit(inside, step.node); }};
  for_each_step(definition.body, visit);
  return use;
}

bool is_among(const std::vector<Name>& names, std::string_view text) {
  return std::any_of(names.begin(), names.end(), [&](const Name& name) { return name.text == text; });
}

grammar::Diagnostic& report_clock(const Name& name, const char* what, grammar::Diagnostics& found) {
  return add_finding(found, Code::unused_clock, name.span,
                     "clock " + backquoted(name.text) + " is " + what + " and never read");
}

/// Component and module types that a plant uses, by way of others too.
std::set<std::string_view> types_used(const grammar::PlantFile& root, const LintInput& input) {
  std::map<std::string_view, const grammar::ModuleDefinition*> modules;
  for (const File& file : input.files) {
    if (!file.plant) continue;
    for (const grammar::PlantItem& item : file.plant->items) {
      if (const auto* module = std::get_if<grammar::ModuleDefinition>(&item))
        modules.emplace(module->name.text, module);
    }
  }
  std::set<std::string_view> used;
  std::vector<const grammar::ModuleDefinition*> pending;
  for (const grammar::PlantItem& item : root.items) {
    const auto* module = std::get_if<grammar::ModuleDefinition>(&item);
    if (module != nullptr && module->plant) pending.push_back(module);
  }
  while (!pending.empty()) {
    const grammar::ModuleDefinition& module = *pending.back();
    pending.pop_back();
    for (const grammar::ModuleItem& item : module.items) {
      const auto* instance = std::get_if<grammar::InstanceDeclaration>(&item);
      if (instance == nullptr || !used.insert(instance->type.text).second) continue;
      if (const auto inner = modules.find(instance->type.text); inner != modules.end())
        pending.push_back(inner->second);
    }
  }
  return used;
}

/// Whether the file holds a plant: what others hold is a library, which nobody has to use in whole.
bool has_plant(const File& file) {
  if (!file.plant) return false;
  return std::any_of(file.plant->items.begin(), file.plant->items.end(), [](const grammar::PlantItem& item) {
    const auto* module = std::get_if<grammar::ModuleDefinition>(&item);
    return module != nullptr && module->plant;
  });
}

}  // namespace

void lint_unused_definitions(const LintInput& input, grammar::Diagnostics& found) {
  std::multimap<std::string_view, const Definition*> by_name;
  for_each_definition(input, [&](const Definition& d) { by_name.emplace(d.name.text, &d); });
  std::set<std::string_view> called;
  for (const auto& [name, definition] : by_name) {
    for (const std::string_view call : calls_in(*definition)) called.insert(call);
  }
  std::set<Span> entries;
  std::set<std::uint32_t> files;  // with a start of a program; others are libraries
  for (const ProgramPlaces& places : input.programs) {
    if (places.locations.empty()) continue;
    entries.insert(places.locations.front());
    files.insert(places.locations.front().file);
  }
  std::set<const Definition*> used;
  std::vector<const Definition*> pending;
  const auto use = [&](const Definition* definition) {
    if (used.insert(definition).second) pending.push_back(definition);
  };
  // What takes nothing and is not called may be where another program starts.
  for (const auto& [name, definition] : by_name) {
    if (entries.count(definition->name.span) || (definition->parameters.empty() && !called.count(name)))
      use(definition);
  }
  while (!pending.empty()) {
    const Definition& definition = *pending.back();
    pending.pop_back();
    for (const std::string_view call : calls_in(definition)) {
      for (auto [callee, end] = by_name.equal_range(call); callee != end; ++callee) use(callee->second);
    }
  }
  for (const auto& [name, definition] : by_name) {
    if (used.count(definition) || !files.count(definition->name.span.file)) continue;
    add_finding(found, Code::unused_definition, definition->name.span,
                "definition " + backquoted(definition->name.text) + " is never called");
  }
}

void lint_unused_parameters(const LintInput& input, grammar::Diagnostics& found) {
  const auto mentions = mentions_of(input);
  for_each_definition(input, [&](const Definition& definition) {
    for (const Name& parameter : definition.parameters) {
      const auto count = mentions.find(parameter.span);
      if (count == mentions.end() || count->second > 1) continue;
      add_finding(
          found, Code::unused_parameter, parameter.span,
          "parameter " + backquoted(parameter.text) + " of " + backquoted(definition.name.text) + " is never used");
    }
  });
}

void lint_unused_clocks(const LintInput& input, grammar::Diagnostics& found) {
  std::set<std::string_view> read;  // clocks of the program, in any definition
  std::vector<Name> started;
  Removals removals(input.sources);
  for_each_definition(input, [&](const Definition& definition) {
    const ClockUse use = clocks_in(definition);
    for (const Name& own : definition.clocks) {
      const bool starts = is_among(use.starts, own.text);
      if (use.reads.count(own.text)) continue;
      auto& finding = report_clock(own, starts ? "started" : "declared", found);
      if (!starts) propose(finding, removals.of_name(own.span));
    }
    for (const std::string_view name : use.reads) {
      if (!is_among(definition.clocks, name)) read.insert(name);
    }
    for (const Name& start : use.starts) {
      if (!is_among(definition.clocks, start.text) && !is_among(definition.parameters, start.text)) {
        started.push_back(start);
      }
    }
  });
  std::set<std::string_view> told;
  for (const Name& start : started) {
    if (!read.count(start.text) && told.insert(start.text).second) report_clock(start, "started", found);
  }
}

void lint_unused_domains(const LintInput& input, grammar::Diagnostics& found) {
  const auto mentions = mentions_of(input);
  Removals removals(input.sources);
  for (const File& file : input.files) {
    if (!has_plant(file)) continue;
    for (const grammar::PlantItem& item : file.plant->items) {
      const auto* domain = std::get_if<grammar::Domain>(&item);
      if (domain == nullptr || mentions.at(domain->name.span) > 1) continue;
      propose(add_finding(found, Code::unused_domain, domain->name.span,
                          "no variable has the domain " + backquoted(domain->name.text)),
              removals.of_statement(domain->span));
    }
  }
}

void lint_unused_types(const LintInput& input, grammar::Diagnostics& found) {
  for (const File& file : input.files) {
    if (!has_plant(file)) continue;
    const auto used = types_used(*file.plant, input);
    const auto check = [&](const Name& name, const char* what) {
      if (used.count(name.text)) return;
      add_finding(found, Code::unused_type, name.span,
                  std::string("the plant has no instance of ") + what + " " + backquoted(name.text));
    };
    for (const grammar::PlantItem& item : file.plant->items) {
      if (const auto* c = std::get_if<grammar::ComponentDefinition>(&item)) check(c->name, "component");
      const auto* m = std::get_if<grammar::ModuleDefinition>(&item);
      if (m != nullptr && !m->plant) check(m->name, "module");
    }
  }
}

}  // namespace rmpl::compiler
