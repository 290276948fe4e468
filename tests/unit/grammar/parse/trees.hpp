// Trees as short text, so that tests can say what a parse should give.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "grammar/parse/parse.hpp"

namespace rmpl::grammar::test {

/// `(& a=on (! b))`, `(-> …)`, `a in {x y}`, `t1>=30s`.
inline std::string tree(const Constraint& constraint) {
  struct Print {
    static std::string list(const std::string& head, const std::vector<Constraint>& operands) {
      std::string text = "(" + head;
      for (const Constraint& operand : operands) text += " " + tree(operand);
      return text + ")";
    }
    std::string operator()(const Truth& n) const { return n.value ? "true" : "false"; }
    std::string operator()(const Reference& n) const { return n.name.text; }
    std::string operator()(const Comparison& n) const { return n.left.text + (n.equal ? "=" : "!=") + n.right.text; }
    std::string operator()(const Membership& n) const {
      std::string text = n.variable.text + " in {";
      for (const Name& value : n.values) text += (&value == n.values.data() ? "" : " ") + value.text;
      return text + "}";
    }
    std::string operator()(const ClockBound& n) const {
      constexpr const char* relations[] = {"<", "<=", ">", ">="};
      return n.clock.text + relations[static_cast<int>(n.relation)] + n.bound.text();
    }
    std::string operator()(const KnowledgeAtom& n) const {
      static constexpr const char* names[] = {"surprise", "noplan", "possible", "likely"};
      std::string text = list(names[static_cast<std::size_t>(n.kind)], n.operands);
      return n.component ? text + "@" + n.component->text : text;
    }
    std::string operator()(const Negation& n) const { return list("!", n.operands); }
    std::string operator()(const Conjunction& n) const { return list("&", n.operands); }
    std::string operator()(const Disjunction& n) const { return list("|", n.operands); }
    std::string operator()(const Implication& n) const { return list("->", n.operands); }
    std::string operator()(const Equivalence& n) const { return list("<->", n.operands); }
  };
  return std::visit(Print{}, constraint.node);
}

inline std::string tree(const Step& step);

/// `[a; b, c]`.
inline std::string tree(const Body& body) {
  std::string text = "[";
  for (const Sequence& thread : body.threads) {
    if (&thread != body.threads.data()) text += ", ";
    for (const Step& step : thread.steps) text += (&step == thread.steps.data() ? "" : "; ") + tree(step);
  }
  return text + "]";
}

/// `(when c A)`, `(if c A B)`, `(start t1)`, `(call F a b)`.
inline std::string tree(const Step& step) {
  struct Print {
    std::string operator()(const Goal& n) const { return tree(n.constraint); }
    std::string operator()(const ClockStart& n) const { return "(start " + n.clock.text + ")"; }
    std::string operator()(const Call& n) const {
      std::string text = "(call " + n.definition.text;
      for (const Argument& argument : n.arguments) {
        const auto* name = std::get_if<Name>(&argument.node);
        text += " " + (name ? name->text : tree(std::get<Constraint>(argument.node)));
      }
      return text + ")";
    }
    std::string operator()(const Block& n) const { return tree(n.body); }
    std::string operator()(const Watching& n) const { return binary("watching", n.condition, *n.step); }
    std::string operator()(const Maintaining& n) const {
      return binary(n.with_do ? "do-maintaining" : "maintaining", n.condition, *n.step);
    }
    std::string operator()(const If& n) const {
      return "(if " + tree(n.condition) + " " + tree(*n.step) + (n.otherwise ? " " + tree(**n.otherwise) : "") + ")";
    }
    std::string operator()(const Unless& n) const { return binary("unless", n.condition, *n.step); }
    std::string operator()(const When& n) const { return binary("when", n.condition, *n.step); }
    std::string operator()(const Whenever& n) const { return binary("whenever", n.condition, *n.step); }
    std::string operator()(const Always& n) const { return "(always " + tree(*n.step) + ")"; }
    std::string operator()(const Nothing&) const { return "()"; }
    std::string operator()(const Each& n) const { return "(each " + tree(n.body) + ")"; }
    std::string operator()(const Repeat& n) const { return "(repeat " + tree(*n.step) + ")"; }
    std::string operator()(const Next& n) const { return "(next " + tree(*n.step) + ")"; }
    std::string operator()(const Choose& n) const {
      std::string text = "(choose";
      for (const Choice& choice : n.choices) text += " " + choice.probability.text + ":" + tree(choice.step);
      return text + ")";
    }
    static std::string binary(const std::string& head, const Constraint& condition, const Step& inner) {
      return "(" + head + " " + tree(condition) + " " + tree(inner) + ")";
    }
  };
  return std::visit(Print{}, step.node);
}

/// A parse of one text: the tree, where there is one, and what was said.
template <class Tree>
struct Parsed {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Tree> tree;  ///< the whole one
  std::optional<Tree> part;  ///< what there is of it where there are errors

  Parsed(Parse<Tree> (*parse)(const Sources&, std::uint32_t, Diagnostics&), std::string text) {
    auto result = parse(sources, sources.add("test", std::move(text)), diagnostics);
    (result.whole ? tree : part) = std::move(result.tree);
  }
  /// `line:column message`, one a line.
  [[nodiscard]] std::string errors() const {
    std::string text;
    for (const Diagnostic& d : diagnostics.sorted()) {
      const Place place = sources[d.span.file].place(d.span.begin);
      text += std::to_string(place.line) + ":" + std::to_string(place.column) + " " + d.message + "\n";
    }
    return text;
  }
};

}  // namespace rmpl::grammar::test
