// Constraints: operators start lines, operands stand below each other.
// SPDX-License-Identifier: MIT
#include "base/overloaded.hpp"
#include "compiler/format/syntax.hpp"

namespace rmpl::compiler {
namespace {

using grammar::Constraint;

/// Parentheses around a constraint: the tree has them as its place only. Nothing else starts with one.
std::size_t take_parentheses(Document& document, std::uint32_t inside) {
  std::size_t count = 0;
  for (; document.next() == "(" && document.next_begin() < inside; ++count) {
    document.take();
    document.open(Breaks::needed, Margin::aligned);
  }
  return count;
}

/// Where what stands between the parentheses of a constraint begins: only a connective starts with an operand, which
/// may have parentheses of its own.
std::uint32_t inner_begin(const Constraint& constraint) {
  return std::visit(base::Overloaded{[](const grammar::Conjunction& node) { return node.operands.front().span.begin; },
                                     [](const grammar::Disjunction& node) { return node.operands.front().span.begin; },
                                     [](const grammar::Implication& node) { return node.operands.front().span.begin; },
                                     [](const grammar::Equivalence& node) { return node.operands.front().span.begin; },
                                     [&](const auto&) { return constraint.span.end; }},
                    constraint.node);
}

/// `a & b & …`, each operator with its right operand.
void write_chain(Document& document, const std::vector<Constraint>& operands) {
  document.open(Breaks::needed, Margin::aligned);
  write(document, operands.front());
  for (std::size_t i = 1; i < operands.size(); ++i) {
    document.line();
    document.take();
    write(document, operands[i]);
  }
  document.close();
}

/// `a -> b`: what is right of the arrow breaks first.
void write_arrow(Document& document, const std::vector<Constraint>& operands, bool column) {
  document.open(Breaks::needed, Margin::aligned);
  write(document, operands.front());
  document.lazy_line();
  if (column) document.stop();
  document.take();
  write(document, operands.back());
  document.close();
}

/// `likely(a = b, 0.95)`: the parenthesis stands close to the word.
void write_knowledge(Document& document, const grammar::KnowledgeAtom& node, const Constraint& constraint) {
  document.take();
  if (document.next() != "(" || document.next_begin() >= constraint.span.end) return;
  document.glue();
  document.take();
  document.open(Breaks::needed, Margin::aligned);
  if (!node.operands.empty()) write(document, node.operands.front());
  if (node.component) document.take_to(node.component->span.end);
  if (node.probability) {
    document.take();
    document.line();
    document.take_to(node.probability->span.end);
  }
  document.close();
  document.take();
}

void write_node(Document& document, const Constraint& constraint, bool column) {
  std::visit(base::Overloaded{[&](const grammar::Conjunction& node) { write_chain(document, node.operands); },
                              [&](const grammar::Disjunction& node) { write_chain(document, node.operands); },
                              [&](const grammar::Implication& node) { write_arrow(document, node.operands, column); },
                              [&](const grammar::Equivalence& node) { write_arrow(document, node.operands, column); },
                              [&](const grammar::Negation& node) {
                                document.take();
                                write(document, node.operands.front());
                              },
                              [&](const grammar::Membership& node) {
                                document.take_to(node.values.front().span.begin);
                                write_list(document, node.values);
                                document.take();
                              },
                              [&](const grammar::KnowledgeAtom& node) { write_knowledge(document, node, constraint); },
                              [&](const grammar::Truth&) { document.take(); },
                              [&](const grammar::Reference& node) { document.take_to(node.name.span.end); },
                              [&](const grammar::Comparison& node) { document.take_to(node.right.span.end); },
                              [&](const grammar::ClockBound& node) { document.take_to(node.bound.span.end); }},
             constraint.node);
}

}  // namespace

void write(Document& document, const Constraint& constraint) {
  const std::size_t parentheses = take_parentheses(document, inner_begin(constraint));
  write_node(document, constraint, false);
  for (std::size_t i = 0; i < parentheses; ++i) {
    document.close();
    document.take();
  }
}

void write_connection(Document& document, const Constraint& constraint) {
  if (inner_begin(constraint) != constraint.span.begin) return write(document, constraint);
  write_node(document, constraint, true);
}

}  // namespace rmpl::compiler
