// Names in a constraint, in order of the text.
// SPDX-License-Identifier: MIT
#include "compiler/check/mention.hpp"

#include <optional>
#include <variant>

#include "base/overloaded.hpp"

namespace rmpl::compiler {

using grammar::Constraint;
using grammar::Name;
using grammar::Span;

namespace {

std::optional<Span> found(std::string_view variable, const Constraint& constraint) {
  const auto named = [&](const Name& name) { return name.text == variable ? std::optional(name.span) : std::nullopt; };
  return std::visit(base::Overloaded{[](const grammar::Truth&) -> std::optional<Span> { return std::nullopt; },
                                     [](const grammar::ClockBound&) -> std::optional<Span> { return std::nullopt; },
                                     [&](const grammar::Reference& reference) { return named(reference.name); },
                                     [&](const grammar::Comparison& comparison) {
                                       const auto left = named(comparison.left);
                                       return left ? left : named(comparison.right);
                                     },
                                     [&](const grammar::Membership& membership) { return named(membership.variable); },
                                     [&](const grammar::KnowledgeAtom& knowledge) -> std::optional<Span> {
                                       if (knowledge.component && knowledge.component->text == variable)
                                         return knowledge.component->span;
                                       if (knowledge.operands.empty()) return std::nullopt;
                                       return found(variable, knowledge.operands.front());
                                     },
                                     [&](const auto& connective) -> std::optional<Span> {
                                       for (const Constraint& operand : connective.operands) {
                                         if (const auto place = found(variable, operand)) return place;
                                       }
                                       return std::nullopt;
                                     }},
                    constraint.node);
}

}  // namespace

Span mention_of(std::string_view variable, const Constraint& constraint) {
  return found(variable, constraint).value_or(constraint.span);
}

}  // namespace rmpl::compiler
