// Constraints as written become formulas.
// SPDX-License-Identifier: MIT
#include "compiler/check/resolve.hpp"

#include <utility>
#include <variant>

#include "base/overloaded.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::ValueId;
using automata::VariableId;
using grammar::Code;
using grammar::Name;

namespace {

/// Up to this size a walk through the domain costs less than an index.
constexpr std::size_t small_domain = 64;

}  // namespace

Formula Resolver::resolve(const grammar::Constraint& constraint) {
  return std::visit(
      base::Overloaded{[&](const grammar::Truth& t) { return automata::constant(t.value); },
                       [&](const grammar::Reference& r) { return reference(r); },
                       [&](const grammar::Comparison& c) { return comparison(c); },
                       [&](const grammar::Membership& m) { return membership(m); },
                       [&](const grammar::ClockBound& b) { return clock(b); },
                       [&](const grammar::KnowledgeAtom& k) { return knowledge(k, constraint.span); },
                       [&](const grammar::Negation& n) { return automata::negation(resolve(n.operands[0])); },
                       [&](const grammar::Conjunction& c) { return automata::conjunction(resolve_all(c.operands)); },
                       [&](const grammar::Disjunction& d) { return automata::disjunction(resolve_all(d.operands)); },
                       [&](const grammar::Implication& i) {
                         Formula premise = resolve(i.operands[0]);
                         return automata::implication(std::move(premise), resolve(i.operands[1]));
                       },
                       [&](const grammar::Equivalence& e) {
                         Formula left = resolve(e.operands[0]);
                         return automata::equivalence(std::move(left), resolve(e.operands[1]));
                       }},
      constraint.node);
}

std::vector<Formula> Resolver::resolve_all(const std::vector<grammar::Constraint>& constraints) {
  std::vector<Formula> formulas;
  formulas.reserve(constraints.size());
  for (const grammar::Constraint& constraint : constraints) formulas.push_back(resolve(constraint));
  return formulas;
}

Formula Resolver::knowledge(const grammar::KnowledgeAtom& atom, grammar::Span span) {
  using Kind = grammar::KnowledgeAtom::Kind;
  if (no_knowledge_) {
    auto& error =
        diagnostics_.error(Code::knowledge_not_allowed, span,
                           "a question about the knowledge of the executive is not allowed " + *no_knowledge_);
    annotate(error);
    return automata::constant(true);
  }
  if (atom.kind == Kind::surprise || atom.kind == Kind::no_plan) {
    const auto knowing = atom.kind == Kind::surprise ? automata::Knowing::surprise : automata::Knowing::no_plan;
    if (!atom.component) return automata::knowledge(knowing);
    const auto id = variable(*atom.component);
    if (!id) return automata::constant(true);
    if (is_component(*id)) return automata::knowledge(knowing, *id);
    auto& error = diagnostics_.error(Code::wrong_kind_of_name, atom.component->span,
                                     backquoted(atom.component->text) + " is an attribute, expected a component");
    note_domain(error, *id);
    annotate(error);
    return automata::constant(true);
  }
  const auto before = std::exchange(no_knowledge_, "inside another such question");
  Formula operand = resolve(atom.operands.front());
  no_knowledge_ = before;
  if (has_clock(operand)) {
    auto& error =
        diagnostics_.error(Code::clock_not_allowed, atom.operands.front().span,
                           "a clock bound inside a question about knowledge: the program always knows its clocks");
    error.suggestion = "move the clock bound outside: `likely(…, 0.9) & t >= 5 s`";
    annotate(error);
    return automata::constant(true);
  }
  double probability = automata::least_possible;
  if (atom.probability) {
    probability = atom.probability->value;
    // What has probability 0 is asked of nothing.
    if (!(probability > 0 && probability <= 1)) {
      auto& error = diagnostics_.error(
          Code::probability_out_of_range, atom.probability->span,
          "`" + atom.probability->text + "` is not a valid threshold, expected a probability above 0 and at most 1");
      annotate(error);
      return automata::constant(true);
    }
  }
  const auto knowing = atom.kind == Kind::possible ? automata::Knowing::possible : automata::Knowing::likely;
  return automata::knowledge(knowing, std::move(operand), probability);
}

void Resolver::taken_for_value(const Name&) {}

void Resolver::annotate(grammar::Diagnostic&) {}

std::optional<Name> Resolver::meaning(const Name& name) { return name; }

std::optional<VariableId> Resolver::variable(const Name& name) {
  const auto meant = meaning(name);
  if (!meant) return std::nullopt;
  const auto id = vocabulary_.variables.find(meant->text);
  if (!id && !lost_its_meaning(*meant)) report_unknown(*meant);
  return id;
}

std::optional<ValueId> Resolver::find_value(VariableId variable, const std::string& value) {
  const automata::Variable& known = vocabulary_.variables[variable];
  if (known.values.size() <= small_domain) return known.find(value);
  auto& index = large_[variable];
  if (index.empty()) {
    for (std::size_t v = 0; v < known.values.size(); ++v) index.emplace(known.values[v], ValueId(v));
  }
  const auto at = index.find(value);
  return at == index.end() ? std::nullopt : std::optional(at->second);
}

Formula Resolver::reference(const grammar::Reference& reference) {
  const Name& name = reference.name;
  auto& error = diagnostics_.error(Code::wrong_kind_of_name, name.span,
                                   "expected a constraint, found the lone name " + backquoted(name.text));
  if (vocabulary_.variables.find(name.text)) error.suggestion = "write `" + name.text + " = …` with one of its values";
  annotate(error);
  return automata::constant(true);
}

Formula Resolver::clock(const grammar::ClockBound& bound) {
  auto& error = diagnostics_.error(Code::clock_in_plant, bound.clock.span,
                                   "clock bound on " + backquoted(bound.clock.text) + " in " + vocabulary_.owner +
                                       ": components cannot read the clocks of programs");
  error.suggestion = "bound the transition by the time in its mode instead: `a -> b after 5 s`, `a -> b in [2 s, 5 s]`";
  return automata::constant(true);
}

Formula Resolver::is_value(VariableId variable, ValueId value, bool equal) {
  std::vector<ValueId> meant = vocabulary_.meant(variable, value);
  if (equal) return automata::member(variable, std::move(meant));
  const std::size_t size = vocabulary_.variables[variable].values.size();
  if (!closed() || size > small_domain) return automata::negation(automata::member(variable, std::move(meant)));
  std::vector<ValueId> rest;
  for (std::size_t v = 0; v < size; ++v) {
    if (!std::binary_search(meant.begin(), meant.end(), ValueId(v))) rest.emplace_back(v);
  }
  return automata::member(variable, std::move(rest));
}

Formula Resolver::comparison(const grammar::Comparison& comparison) {
  const auto left = variable(comparison.left);
  const auto right = meaning(comparison.right);
  if (!left || !right) return automata::constant(true);
  const auto value = find_value(*left, right->text);
  if (!closed()) taken_for_value(*right);
  const auto other = closed() ? vocabulary_.variables.find(right->text) : std::nullopt;
  const auto same_domain = [&](VariableId a, VariableId b) {
    return vocabulary_.variables[a].values == vocabulary_.variables[b].values;
  };
  if (value && other && same_domain(*left, *other)) {
    auto& error =
        diagnostics_.error(Code::ambiguous_name, right->span,
                           backquoted(right->text) + " is both a value of " +
                               backquoted(vocabulary_.variables.name(*left)) + " and a variable of the same domain");
    note_domain(error, *left);
    if (const auto place = vocabulary_.declaration(*other)) {
      error.notes.push_back({*place, "the variable " + backquoted(right->text) + " has this domain"});
    }
    error.suggestion = "rename the value or the variable";
    annotate(error);
    return automata::constant(true);
  }
  if (value) return is_value(*left, *value, comparison.equal);
  if (!other) {
    report_value(*left, *right);
    return automata::constant(true);
  }
  if (!same_domain(*left, *other)) {
    auto& error = diagnostics_.error(Code::different_domains, join(comparison.left.span, comparison.right.span),
                                     backquoted(vocabulary_.variables.name(*left)) + " and " + backquoted(right->text) +
                                         " have different domains, so they cannot be compared");
    note_domain(error, *left);
    note_domain(error, *other);
    annotate(error);
    return automata::constant(true);
  }
  Formula equality = automata::equality(*left, *other);
  return comparison.equal ? equality : automata::negation(std::move(equality));
}

Formula Resolver::membership(const grammar::Membership& membership) {
  const auto left = variable(membership.variable);
  if (!left) return automata::constant(true);
  std::vector<ValueId> values;
  bool complete = true;
  for (const Name& name : membership.values) {
    const auto meant = meaning(name);
    const auto value = meant ? find_value(*left, meant->text) : std::nullopt;
    if (meant && !value) report_value(*left, *meant);
    if (value) {
      for (const ValueId one : vocabulary_.meant(*left, *value)) values.push_back(one);
    }
    complete = complete && value;
  }
  return complete ? automata::member(*left, std::move(values)) : automata::constant(true);
}

std::optional<automata::Assignment> Resolver::assignment(const Name& name, const Name& value) {
  const auto id = variable(name);
  const auto meant = meaning(value);
  if (!id || !meant) return std::nullopt;
  const auto known = find_value(*id, meant->text);
  if (!known) {
    report_value(*id, *meant);
    return std::nullopt;
  }
  return automata::Assignment{*id, *known};
}

void Resolver::report_unknown(const Name& name) {
  const std::size_t before = diagnostics_.error_count();
  auto& error = diagnostics_.error(vocabulary_.unknown, name.span,
                                   vocabulary_.owner + " has no variable " + backquoted(name.text));
  suggest(error, before, name.text, names_of(vocabulary_.variables));
  annotate(error);
}

void Resolver::report_value(VariableId id, const Name& value) {
  if (lost_its_meaning(value)) return;
  const std::size_t before = diagnostics_.error_count();
  const automata::Variable& known = vocabulary_.variables[id];
  auto& error = diagnostics_.error(
      Code::value_outside_domain, value.span,
      backquoted(value.text) + " is no value of " + backquoted(known.name) + ", expected " + one_of(known.values));
  suggest(error, before, value.text, known.values);
  const std::size_t minus = value.text.rfind('-');
  if (!error.suggestion && minus != std::string::npos &&
      value.text.find_first_not_of("0123456789", minus + 1) == std::string::npos) {
    error.suggestion = backquoted(value.text) + " is a single name: `-` does not subtract";
  }
  note_domain(error, id);
  annotate(error);
}

void Resolver::note_domain(grammar::Diagnostic& diagnostic, VariableId variable) {
  if (const auto place = vocabulary_.declaration(variable)) {
    diagnostic.notes.push_back(
        {*place, "the domain of " + backquoted(vocabulary_.variables.name(variable)) + " is here"});
  }
}

}  // namespace rmpl::compiler
