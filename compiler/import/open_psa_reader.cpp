// Open-PSA Model Exchange Format 2.0: definitions anywhere under opsa-mef, in any order.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <set>

#include "compiler/check/vocabulary.hpp"
#include "compiler/import/fault_tree.hpp"

namespace rmpl::compiler {
namespace {

using grammar::Code;
using grammar::Span;
using NodeKind = TreeNode::Kind;

/// Expressions and formulas that are nested deeper than this are refused.
constexpr int deepest = 1000;

/// What a basic event is given.
struct Chance {
  std::optional<double> probability;
  double rate = 0;
};

class OpenPsaReader {
 public:
  OpenPsaReader(const grammar::SourceFile& file, std::uint32_t index, grammar::Diagnostics& diagnostics)
      : text_(file.text()), index_(index), errors_(diagnostics) {}

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
  [[nodiscard]] Span span(pugi::xml_node element) const {
    const auto begin = static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(element.offset_debug(), 0));
    return {index_, begin, begin + static_cast<std::uint32_t>(std::string_view(element.name()).size())};
  }
  static std::string name_of(pugi::xml_node element) { return element.attribute("name").value(); }

  /// Names first, as definitions may come in any order.
  void collect(pugi::xml_node parent, int depth) {
    if (depth > deepest) {
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
        if (!parameters_.emplace(name_of(element), element).second) {
          errors_.report(Code::netlist_driver, span(element), backquoted(name_of(element)) + " is defined twice");
        }
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
    const std::string name = name_of(element);
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

  static pugi::xml_node first_child(pugi::xml_node element) {
    for (const pugi::xml_node child : element.children()) {
      const std::string_view kind = child.name();
      if (child.type() == pugi::node_element && kind != "label" && kind != "attributes") return child;
    }
    return {};
  }
  static std::vector<pugi::xml_node> children_of(pugi::xml_node element) {
    std::vector<pugi::xml_node> result;
    for (const pugi::xml_node child : element.children()) {
      const std::string_view kind = child.name();
      if (child.type() == pugi::node_element && kind != "label" && kind != "attributes") result.push_back(child);
    }
    return result;
  }

  void define_gate(pugi::xml_node element) {
    const TreeNodeId node = names_.at(name_of(element));
    const pugi::xml_node formula = first_child(element);
    if (!formula) {
      errors_.report(Code::netlist_syntax, span(element),
                     "the gate " + backquoted(name_of(element)) + " has no formula");
      return;
    }
    define(node, formula, 0);
  }

  /// A formula that stands inside another one becomes a gate of its own.
  std::optional<TreeNodeId> node_of(TreeNodeId owner, pugi::xml_node formula, int depth) {
    const std::string_view kind = formula.name();
    if (kind == "gate" || kind == "basic-event" || kind == "house-event" || kind == "event") {
      const auto at = names_.find(name_of(formula));
      if (at != names_.end()) return at->second;
      errors_.report(
          Code::netlist_driver, span(formula),
          backquoted(tree_.nodes[owner].name) + " reads " + backquoted(name_of(formula)) + ", which nothing defines");
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
    if (depth > deepest) {
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
    for (const pugi::xml_node child : children_of(formula)) {
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
    TreeNode& node = tree_.nodes[names_.at(name_of(element))];
    if (node.kind != NodeKind::basic) return;  // of a common-cause group
    const pugi::xml_node expression = first_child(element);
    if (!expression) {
      errors_.report(Code::netlist_gate, span(element),
                     "the basic event " + backquoted(node.name) + " has no probability");
      return;
    }
    const Chance chance = chance_of(expression);
    node.probability = chance.probability;
    node.rate = chance.rate;
  }

  Chance chance_of(pugi::xml_node expression) {
    const pugi::xml_node given = resolved(expression);
    if (std::string_view(given.name()) == "exponential") {
      const std::vector<pugi::xml_node> parts = children_of(given);
      if (parts.size() != 2) {
        errors_.report(Code::netlist_syntax, span(given), "expected a rate and a time in exponential");
        return {0.0};
      }
      const double rate = value(parts[0], 0);
      if (rate < 0)
        errors_.report(Code::negative_rate, span(parts[0]), "a rate is at least 0, and this is " + text(rate));
      const double unit = unit_of_time(given);
      if (std::string_view(resolved(parts[1]).name()) == "system-mission-time") return {std::nullopt, rate / unit};
      const double time = value(parts[1], 0);
      if (time < 0)
        errors_.report(Code::netlist_gate, span(parts[1]), "a time is at least 0, and this is " + text(time));
      return {-std::expm1(-rate * time)};
    }
    const double probability = value(expression, 0);
    if (!(probability >= 0 && probability <= 1)) {
      errors_.report(Code::probability_out_of_range, span(expression),
                     "a probability is from 0 to 1, and this is " + text(probability));
    }
    return {probability};
  }

  static std::string text(double number) {
    char buffer[40];
    const auto [end, failure] = std::to_chars(buffer, buffer + sizeof buffer, number);
    return failure == std::errc() ? std::string(buffer, end) : "?";
  }

  /// A parameter stands for its expression.
  pugi::xml_node resolved(pugi::xml_node expression) {
    std::set<std::string> seen;
    while (std::string_view(expression.name()) == "parameter") {
      const std::string name = name_of(expression);
      const auto at = parameters_.find(name);
      if (at == parameters_.end()) return expression;
      if (!seen.insert(name).second) {
        errors_.report(Code::netlist_loop, span(expression),
                       "the parameter " + backquoted(name) + " is defined by itself");
        return {};
      }
      expression = first_child(at->second);
    }
    return expression;
  }

  /// The seconds in the unit of time that an expression and its parameters count in: one where they state none.
  double unit_of_time(pugi::xml_node expression) {
    std::set<double> units;
    std::set<std::string> seen;
    collect_units(expression, 0, units, seen);
    if (units.size() > 1) {
      errors_.report(Code::netlist_gate, span(expression),
                     "rate and time count in different units of time: expected one, as each is taken as it is");
    }
    return units.empty() ? 1.0 : *units.begin();
  }

  void collect_units(pugi::xml_node expression, int depth, std::set<double>& units, std::set<std::string>& seen) {
    if (depth > deepest) return;  // `value` reports it
    collect_unit(expression, units);
    if (std::string_view(expression.name()) == "parameter") {
      const auto at = parameters_.find(name_of(expression));
      if (at == parameters_.end() || !seen.insert(at->first).second) return;
      collect_unit(at->second, units);
      expression = at->second;
    }
    for (const pugi::xml_node part : children_of(expression)) collect_units(part, depth + 1, units, seen);
  }

  /// The units of the format. A year is one of 365 days.
  void collect_unit(pugi::xml_node element, std::set<double>& units) {
    constexpr double hour = 3600, year = 8760 * hour;
    static const std::map<std::string_view, double> known = {{"bool", 0},     {"int", 0},        {"float", 0},
                                                             {"demands", 0},  {"hours", hour},   {"hours-1", hour},
                                                             {"years", year}, {"years-1", year}, {"fit", 1e9 * hour}};
    const pugi::xml_attribute attribute = element.attribute("unit");
    if (!attribute) return;
    const auto unit = known.find(attribute.value());
    if (unit == known.end()) {
      errors_.report(Code::netlist_syntax, span(element),
                     "unknown unit " + backquoted(attribute.value()) +
                         ", expected hours, hours-1, years, years-1, fit, demands, bool, int or float");
    } else if (unit->second > 0) {
      units.insert(unit->second);
    }
  }

  double value(pugi::xml_node expression, int depth) {
    const std::string_view kind = expression.name();
    if (depth > deepest) {
      errors_.report(Code::nesting_too_deep, span(expression),
                     "the expression is nested too deep, or defined by itself");
      return 0;
    }
    if (kind == "float" || kind == "int") {
      const std::string_view given = expression.attribute("value").value();
      double number = 0;
      const auto [end, failure] = std::from_chars(given.data(), given.data() + given.size(), number);
      if (failure != std::errc() || end != given.data() + given.size() || !std::isfinite(number)) {
        errors_.report(Code::netlist_syntax, span(expression), "expected a number, not " + backquoted(given));
        return 0;
      }
      return number;
    }
    if (kind == "parameter") {
      const auto at = parameters_.find(name_of(expression));
      if (at == parameters_.end()) {
        errors_.report(Code::netlist_driver, span(expression),
                       "nothing defines the parameter " + backquoted(name_of(expression)));
        return 0;
      }
      // Once each: a parameter that is read twice, and so on, would else be worked out twice as often each time.
      const auto known = values_.find(at->first);
      if (known != values_.end()) return known->second;
      const double result = value(first_child(at->second), depth + 1);
      values_.emplace(at->first, result);
      return result;
    }
    const std::vector<pugi::xml_node> parts = children_of(expression);
    std::vector<double> values;
    if (kind == "neg" || kind == "add" || kind == "sub" || kind == "mul" || kind == "div") {
      for (const pugi::xml_node part : parts) values.push_back(value(part, depth + 1));
      if (values.empty()) {
        errors_.report(Code::netlist_syntax, span(expression), "an operation without numbers");
        return 0;
      }
      double result = kind == "neg" ? -values.front() : values.front();
      for (std::size_t i = 1; i < values.size(); ++i) {
        result = kind == "add"   ? result + values[i]
                 : kind == "sub" ? result - values[i]
                 : kind == "mul" ? result * values[i]
                                 : result / values[i];
      }
      return result;
    }
    errors_.report(
        Code::netlist_gate, span(expression),
        (kind.empty() ? std::string("a definition without a number") : backquoted(kind) + " is not imported") +
            ", expected float, int, parameter, exponential or arithmetic");
    return 0;
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
        first_child(element.child("factors") ? element.child("factors").child("factor") : element.child("factor"));
    const pugi::xml_node distribution = first_child(element.child("distribution"));
    if (!factor || !distribution) {
      errors_.report(Code::netlist_syntax, span(element), "a common-cause group without distribution or factor");
      return;
    }
    const double beta = value(factor, 0);
    if (!(beta >= 0 && beta <= 1)) {
      errors_.report(Code::probability_out_of_range, span(factor),
                     "a beta factor is from 0 to 1, and this is " + text(beta));
      return;
    }
    const Chance chance = chance_of(distribution);
    if (!chance.probability) {
      errors_.report(
          Code::netlist_gate, span(distribution),
          "a part of an exponential chance is none: expected a constant probability in a common-cause group");
      return;
    }
    TreeNode common;
    common.name = name_of(element) + ".common";
    common.place = span(element);
    common.probability = beta * *chance.probability;
    const TreeNodeId shared = tree_.nodes.size();
    tree_.nodes.push_back(std::move(common));
    for (const pugi::xml_node member : element.child("members").children("basic-event")) {
      const auto at = names_.find(name_of(member));
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
      const TreeNodeId node = names_.at(name_of(gate));
      if (!read[node]) {
        tree_.top = node;
        return;
      }
    }
  }

  std::string_view text_;
  std::uint32_t index_;
  NetlistErrors errors_;
  FaultTree tree_;
  std::map<std::string, TreeNodeId> names_;
  std::map<TreeNodeId, int> inner_;  ///< formulas inside a gate that have become gates
  std::map<std::string, pugi::xml_node> parameters_;
  std::map<std::string, double> values_;  ///< of parameters
  std::vector<pugi::xml_node> gates_, events_, groups_;
};

}  // namespace

std::optional<FaultTree> read_open_psa(const grammar::Sources& sources, std::uint32_t file,
                                       grammar::Diagnostics& diagnostics) {
  return OpenPsaReader(sources[file], file, diagnostics).run();
}

}  // namespace rmpl::compiler
