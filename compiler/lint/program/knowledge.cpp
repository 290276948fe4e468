// What programs ask of the executive's knowledge, and to no purpose.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "automata/dependencies/dependencies.hpp"
#include "base/overloaded.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/program/bound_programs.hpp"
#include "compiler/lint/program/passes.hpp"
#include "compiler/lint/program/possibilities.hpp"
#include "compiler/lint/program/reachable_modes.hpp"
#include "compiler/lint/tree_walk.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::Knowing;
using grammar::Code;
using grammar::Span;

namespace {

/// Why a formula can have no probability; nothing where it can.
std::optional<std::string> why_never(const Formula& formula, Possibilities& possible,
                                     const std::optional<Formula>& reachable) {
  if (!possible.can_hold(formula)) return "no state of the plant satisfies it";
  if (reachable && !possible.can_hold(automata::conjunction({formula, *reachable})))
    return "no mode that the plant can reach satisfies it";
  return std::nullopt;
}

/// What the atoms of a condition ask, as far as it can never be; by the place of the condition, once for all programs
/// in which it is so.
void look_at(const BoundProgram& bound, std::map<Span, std::optional<std::string>>& told) {
  Possibilities possible(bound.program.variables, bound.plant);
  if (!possible.consistent()) return;
  std::optional<Formula> reachable;
  if (bound.plant != nullptr) reachable = ReachableModes(*bound.plant, bound.also).formula();
  for (const PlacedCondition& condition : bound.places.conditions) {
    std::vector<Formula> atoms;
    collect_knowledge(condition.formula, atoms);
    std::optional<std::string> text;
    bool asks = false;
    for (const Formula& atom : atoms) {
      if (atom.operands.empty()) continue;
      asks = true;
      const auto why = why_never(atom.operands.front(), possible, reachable);
      if (why && !text) text = backquoted(to_text(atom, bound.program.variables)) + " never holds: " + *why;
    }
    if (!asks) continue;
    const auto [known, fresh] = told.emplace(condition.span, text);
    if (!fresh && known->second != text) known->second.reset();
  }
}

bool asks_surprise(const grammar::Constraint& constraint) {
  return std::visit(
      base::Overloaded{
          [](const grammar::KnowledgeAtom& atom) { return atom.kind == grammar::KnowledgeAtom::Kind::surprise; },
          [](const grammar::Truth&) { return false; }, [](const grammar::Reference&) { return false; },
          [](const grammar::Comparison&) { return false; }, [](const grammar::Membership&) { return false; },
          [](const grammar::ClockBound&) { return false; },
          [](const auto& connective) {
            return std::any_of(connective.operands.begin(), connective.operands.end(), asks_surprise);
          }},
      constraint.node);
}

bool does_nothing(const grammar::Step& step) { return std::holds_alternative<grammar::Nothing>(step.node); }

/// Conditions on a surprise behind which nothing is done; `when` waits for one, which is something.
void report_empty_answers(const LintInput& input, grammar::Diagnostics& found) {
  const auto report = [&](const grammar::Constraint& condition) {
    if (!asks_surprise(condition)) return;
    auto& finding =
        add_finding(found, Code::unanswered_surprise, condition.span, "the program does not react to this surprise");
    finding.suggestion = "replace the empty step `{ }` with a reaction";
  };
  const base::Overloaded inside{[&](const grammar::Whenever& node) {
                                  if (does_nothing(*node.step)) report(node.condition);
                                },
                                [&](const grammar::If& node) {
                                  if (does_nothing(*node.step) && (!node.otherwise || does_nothing(**node.otherwise)))
                                    report(node.condition);
                                },
                                [](const auto&) {}};
  const base::Overloaded visit{[](const grammar::Body&) {},
                               [&](const grammar::Step& step) { std::visit(inside, step.node); }};
  for_each_definition(input, [&](const grammar::Definition& definition) { for_each_step(definition.body, visit); });
}

/// Observed components, the first of each group, whose surprises a program lets pass while it asks for others'.
void report_unasked(const BoundProgram& bound, std::set<Span>& told, grammar::Diagnostics& found) {
  if (bound.plant == nullptr) return;
  std::vector<std::pair<automata::VariableId, Span>> asked;
  for (const PlacedCondition& condition : bound.places.conditions) {
    std::vector<Formula> atoms;
    collect_knowledge(condition.formula, atoms);
    for (const Formula& atom : atoms) {
      if (atom.knowing != Knowing::surprise) continue;
      if (!atom.about_one) return;
      asked.emplace_back(atom.variable, condition.span);
    }
  }
  if (asked.empty()) return;
  const automata::Dependencies dependencies(*bound.plant);
  const automata::Classes groups = dependencies.groups();
  std::set<std::size_t> answered, open;
  for (const auto& [component, span] : asked) answered.insert(*groups[component]);
  for (const automata::VariableId observed : bound.plant->observables) {
    const auto group = groups[observed];
    if (group && !answered.contains(*group)) open.insert(*group);
  }
  std::string names;
  for (const automata::Component& component : bound.plant->components) {
    if (open.erase(*groups[component.mode]) != 0) names += (names.empty() ? "" : ", ") + backquoted(component.name);
  }
  if (names.empty() || !told.insert(asked.front().second).second) return;
  auto& finding = add_finding(found, Code::unanswered_surprise, asked.front().second,
                              "the program does not react to a surprise of " + names + ", whose readings are observed");
  finding.suggestion = "`surprise` without a component asks for surprises of all components";
}

}  // namespace

void lint_knowledge(const LintInput& input, grammar::Diagnostics& found) {
  std::map<Span, std::optional<std::string>> never;
  std::set<Span> unasked;
  for (const BoundProgram& bound : bound_programs(input)) {
    look_at(bound, never);
    report_unasked(bound, unasked, found);
  }
  for (const auto& [span, text] : never) {
    if (text) add_finding(found, Code::knowledge_out_of_reach, span, *text);
  }
  report_empty_answers(input, found);
}

}  // namespace rmpl::compiler
