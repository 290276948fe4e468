// Open-PSA Model Exchange Format 2.0: definitions anywhere under opsa-mef, in any order.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <map>
#include <pugixml.hpp>

#include "compiler/check/vocabulary.hpp"
#include "compiler/import/fault_tree.hpp"
#include "compiler/import/open_psa_expressions.hpp"

namespace rmpl::compiler {
namespace {

using grammar::Code;
using grammar::Span;
using NodeKind = TreeNode::Kind;

class OpenPsaReader {
 public:
  OpenPsaReader(const grammar::SourceFile& file, std::uint32_t index, grammar::Diagnostics& diagnostics)
      : text_(file.text()), index_(index), errors_(diagnostics), expressions_(index, errors_) {}

  std::optional<FaultTree> run() {
    pugi::xml_document document;
    const auto parsed = document.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!parsed) {
      const auto at = static_cast<std::uint32_t>(std::min(std::ssize(text_), parsed.offset));
      errors_.report(Code::netlist_syntax, {index_, at, at}, std::string("no XML: ") + parsed.description());
      return std::nullopt;
    }
    const pugi::xml_node root = document.child("opsa-mef");
    if (!root) {
      errors_.report(Code::netlist_syntax, {index_, 0, 0}, "expected opsa-mef");
      return std::nullopt;
    }
    tree_.name = root.attribute("name").value();
    collect(root, 0);
    for (const pugi::xml_node element : groups_) define_group(element);  // whose members need no other definition
    for (const pugi::xml_node element : gates_) define_gate(element);
    for (const pugi::xml_node element : events_) define_event(element);
    if (errors_.any()) return std::nullopt;
    find_top();
    if (!tree_.top) {
      const Span place = gates_.empty() ? span(root) : span(gates_.front());
      errors_.report(Code::netlist_syntax, place,
                     gates_.empty() ? "a fault tree without a gate" : "each gate is read by another one: a loop");
    }
    if (errors_.any() || !check_tree(tree_, errors_)) return std::nullopt;
    return std::move(tree_);
  }

 private:
  [[nodiscard]] Span span(pugi::xml_node element) const { return expressions_.span(element); }

  /// Names first, as definitions may come in any order.
  void collect(pugi::xml_node parent, int depth) {
    if (depth > deepest_open_psa) {
      errors_.report(Code::nesting_too_deep, span(parent), "elements are nested too deep");
      return;
    }
    for (const pugi::xml_node element : parent.children()) {
      if (element.type() != pugi::node_element) continue;
      const std::string_view kind = element.name();
      if (kind == "define-gate") {
        gates_.push_back(element);
        declare(element, NodeKind::disjunction);
      } else if (kind == "define-basic-event") {
        events_.push_back(element);
        declare(element, NodeKind::basic);
      } else if (kind == "define-house-event") {
        const TreeNodeId node = declare(element, NodeKind::house);
        tree_.nodes[node].failed = std::string_view(element.child("constant").attribute("value").value()) == "true";
      } else if (kind == "define-parameter") {
        expressions_.define(element);
      } else if (kind == "define-CCF-group") {
        groups_.push_back(element);
      } else if (kind == "define-fault-tree" || kind == "define-component" || kind == "model-data") {
        collect(element, depth + 1);
      } else if (kind != "label" && kind != "attributes") {
        errors_.report(Code::netlist_gate, span(element), backquoted(kind) + " is not imported");
      }
    }
  }

  TreeNodeId declare(pugi::xml_node element, NodeKind kind) {
    const std::string name = open_psa_name(element);
    if (name.empty()) errors_.report(Code::netlist_syntax, span(element), "a definition without a name");
    const auto [at, fresh] = names_.try_emplace(name, tree_.nodes.size());
    if (!fresh) {
      if (auto* error = errors_.report(Code::netlist_driver, span(element), backquoted(name) + " is defined twice")) {
        error->notes.push_back({tree_.nodes[at->second].place, "the other one is here"});
      }
    }
    TreeNode node;
    node.name = name;
    node.kind = kind;
    node.place = span(element);
    tree_.nodes.push_back(std::move(node));
    return tree_.nodes.size() - 1;
  }

  void define_gate(pugi::xml_node element) {
    const TreeNodeId node = names_.at(open_psa_name(element));
    const pugi::xml_node formula = open_psa_child(element);
    if (!formula) {
      errors_.report(Code::netlist_syntax, span(element),
                     "the gate " + backquoted(open_psa_name(element)) + " has no formula");
      return;
    }
    define(node, formula, 0);
  }

  /// A formula that stands inside another one becomes a gate of its own.
  std::optional<TreeNodeId> node_of(TreeNodeId owner, pugi::xml_node formula, int depth) {
    const std::string_view kind = formula.name();
    if (kind == "gate" || kind == "basic-event" || kind == "house-event" || kind == "event") {
      const auto at = names_.find(open_psa_name(formula));
      if (at != names_.end()) return at->second;
      errors_.report(Code::netlist_driver, span(formula),
                     backquoted(tree_.nodes[owner].name) + " reads " + backquoted(open_psa_name(formula)) +
                         ", which nothing defines");
      return std::nullopt;
    }
    TreeNode inner;
    inner.name = tree_.nodes[owner].name + "." + std::to_string(++inner_[owner]);
    inner.place = span(formula);
    const TreeNodeId result = tree_.nodes.size();
    tree_.nodes.push_back(std::move(inner));
    define(result, formula, depth + 1);
    return result;
  }

  void define(TreeNodeId node, pugi::xml_node formula, int depth) {
    if (depth > deepest_open_psa) {
      errors_.report(Code::nesting_too_deep, span(formula), "the formula is nested too deep");
      return;
    }
    static const std::map<std::string_view, std::pair<NodeKind, bool>> kinds = {
        {"and", {NodeKind::conjunction, false}}, {"or", {NodeKind::disjunction, false}},
        {"not", {NodeKind::negation, false}},    {"xor", {NodeKind::exclusive, false}},
        {"nand", {NodeKind::conjunction, true}}, {"nor", {NodeKind::disjunction, true}},
        {"iff", {NodeKind::exclusive, true}},    {"atleast", {NodeKind::vote, false}}};
    const std::string_view word = formula.name();
    if (word == "constant") {
      tree_.nodes[node].kind = NodeKind::house;
      tree_.nodes[node].failed = std::string_view(formula.attribute("value").value()) == "true";
      return;
    }
    if (word == "gate" || word == "basic-event" || word == "house-event" || word == "event") {
      const auto input = node_of(node, formula, depth);
      tree_.nodes[node].kind = NodeKind::disjunction;
      if (input) tree_.nodes[node].inputs = {*input};
      return;
    }
    const auto kind = kinds.find(word);
    if (kind == kinds.end()) {
      errors_.report(Code::netlist_gate, span(formula),
                     "unknown gate " + backquoted(word) +
                         ", expected and, or, not, xor, nand, nor, iff, atleast, constant or an event");
      return;
    }
    const auto [made, negated] = kind->second;
    TreeNodeId target = node;
    if (negated) {
      TreeNode inner;
      inner.name = tree_.nodes[node].name + "." + std::to_string(++inner_[node]);
      inner.place = span(formula);
      target = tree_.nodes.size();
      tree_.nodes.push_back(std::move(inner));
      tree_.nodes[node].kind = NodeKind::negation;
      tree_.nodes[node].inputs = {target};
    }
    std::vector<TreeNodeId> inputs;
    for (const pugi::xml_node child : open_psa_children(formula)) {
      if (const auto input = node_of(target, child, depth)) inputs.push_back(*input);
    }
    tree_.nodes[target].kind = made;
    tree_.nodes[target].inputs = std::move(inputs);
    if (made != NodeKind::vote) return;
    const std::string_view least = formula.attribute("min").value();
    std::size_t& at_least = tree_.nodes[target].at_least;
    const auto [end, failure] = std::from_chars(least.data(), least.data() + least.size(), at_least);
    if (failure != std::errc() || end != least.data() + least.size()) {
      errors_.report(Code::netlist_gate, span(formula), "expected a whole number in `min` of atleast");
    }
  }

  void define_event(pugi::xml_node element) {
    TreeNode& node = tree_.nodes[names_.at(open_psa_name(element))];
    if (node.kind != NodeKind::basic) return;  // of a common-cause group
    const pugi::xml_node expression = open_psa_child(element);
    if (!expression) {
      errors_.report(Code::netlist_gate, span(element),
                     "the basic event " + backquoted(node.name) + " has no probability");
      return;
    }
    const OpenPsaExpressions::Chance chance = expressions_.chance_of(expression);
    node.probability = chance.probability;
    node.rate = chance.rate;
  }

  /// Each member fails by itself, or together with all others.
  void define_group(pugi::xml_node element) {
    const std::string model = element.attribute("model").value();
    if (model != "beta-factor") {
      errors_.report(
          Code::netlist_gate, span(element),
          "common-cause groups of the model " + backquoted(model) + " are not imported, expected beta-factor");
      return;
    }
    const pugi::xml_node factor =
        open_psa_child(element.child("factors") ? element.child("factors").child("factor") : element.child("factor"));
    const pugi::xml_node distribution = open_psa_child(element.child("distribution"));
    if (!factor || !distribution) {
      errors_.report(Code::netlist_syntax, span(element), "a common-cause group without distribution or factor");
      return;
    }
    const double beta = expressions_.value(factor);
    if (!(beta >= 0 && beta <= 1)) {
      errors_.report(Code::probability_out_of_range, span(factor),
                     "a beta factor is from 0 to 1, and this is " + open_psa_number(beta));
      return;
    }
    const OpenPsaExpressions::Chance chance = expressions_.chance_of(distribution);
    if (!chance.probability) {
      errors_.report(
          Code::netlist_gate, span(distribution),
          "a part of an exponential chance is none: expected a constant probability in a common-cause group");
      return;
    }
    TreeNode common;
    common.name = open_psa_name(element) + ".common";
    common.place = span(element);
    common.probability = beta * *chance.probability;
    const TreeNodeId shared = tree_.nodes.size();
    tree_.nodes.push_back(std::move(common));
    for (const pugi::xml_node member : element.child("members").children("basic-event")) {
      const auto at = names_.find(open_psa_name(member));
      if (at == names_.end()) {
        member_of(declare(member, NodeKind::basic), *chance.probability * (1 - beta), shared, span(member));
      } else {
        member_of(at->second, *chance.probability * (1 - beta), shared, span(member));
      }
    }
  }

  void member_of(TreeNodeId node, double alone, TreeNodeId shared, Span place) {
    TreeNode own;
    own.name = tree_.nodes[node].name + ".alone";
    own.place = place;
    own.probability = alone;
    const TreeNodeId by_itself = tree_.nodes.size();
    tree_.nodes.push_back(std::move(own));
    tree_.nodes[node].kind = NodeKind::disjunction;
    tree_.nodes[node].inputs = {by_itself, shared};
  }

  /// The first gate that no other one reads.
  void find_top() {
    std::vector<bool> read(tree_.nodes.size(), false);
    for (const TreeNode& node : tree_.nodes) {
      for (const TreeNodeId input : node.inputs) read[input] = true;
    }
    for (const pugi::xml_node gate : gates_) {
      const TreeNodeId node = names_.at(open_psa_name(gate));
      if (!read[node]) {
        tree_.top = node;
        return;
      }
    }
  }

  std::string_view text_;
  std::uint32_t index_;
  NetlistErrors errors_;
  OpenPsaExpressions expressions_;
  FaultTree tree_;
  std::map<std::string, TreeNodeId> names_;
  std::map<TreeNodeId, int> inner_;  ///< formulas inside a gate that have become gates
  std::vector<pugi::xml_node> gates_, events_, groups_;
};

}  // namespace

std::optional<FaultTree> read_open_psa(const grammar::Sources& sources, std::uint32_t file,
                                       grammar::Diagnostics& diagnostics) {
  return OpenPsaReader(sources[file], file, diagnostics).run();
}

}  // namespace rmpl::compiler
