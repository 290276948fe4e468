// XMPL in its three dialects, read into one form.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <pugixml.hpp>
#include <sstream>
#include <string_view>

#include "compiler/check/vocabulary.hpp"
#include "compiler/import/xmpl.hpp"

namespace rmpl::compiler {
namespace {

using grammar::Code;
using grammar::Span;

/// Ranks that have names; others are written as probabilities.
constexpr std::array<std::pair<std::string_view, int>, 5> ranks{
    {{"likely", 1}, {"lessLikely", 2}, {"unlikely", 3}, {"rare", 4}, {"unknownFaultRank", 10}}};

std::vector<std::string> words(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> found;
  for (std::string word; in >> word;) found.push_back(word);
  return found;
}

class XmplReader {
 public:
  XmplReader(const grammar::SourceFile& file, std::uint32_t index, XmplModel& model, grammar::Diagnostics& diagnostics)
      : text_(file.text()), index_(index), model_(model), diagnostics_(diagnostics) {}

  bool run() {
    const std::size_t errors = diagnostics_.error_count();
    pugi::xml_document document;
    const auto parsed = document.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!parsed) {
      const auto at = static_cast<std::uint32_t>(std::min(std::ssize(text_), parsed.offset));
      diagnostics_.error(Code::netlist_syntax, {index_, at, at}, std::string("no XML: ") + parsed.description());
      return false;
    }
    const pugi::xml_node root = document.document_element();
    if (is(root, "xmpl")) {
      for (const pugi::xml_node& child : root.children()) part(child);
    } else {
      part(root);
    }
    return diagnostics_.error_count() == errors;
  }

 private:
  [[nodiscard]] Span span(pugi::xml_node element) const {
    const auto begin = static_cast<std::uint32_t>(element.offset_debug());
    return {index_, begin, begin + static_cast<std::uint32_t>(std::string_view(element.name()).size())};
  }

  /// The name of an element without its name space, whatever the case of its letters.
  static bool is(pugi::xml_node element, std::string_view name) {
    std::string_view own = element.name();
    if (own.starts_with("ci:")) own.remove_prefix(3);
    return std::equal(own.begin(), own.end(), name.begin(), name.end(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
  }

  void refuse(pugi::xml_node element, const std::string& why) {
    if (element.type() == pugi::node_element) diagnostics_.error(Code::netlist_gate, span(element), why);
  }

  std::string attribute(pugi::xml_node element, const char* name) {
    const pugi::xml_attribute found = element.attribute(name);
    if (!found) {
      diagnostics_.error(Code::netlist_syntax, span(element),
                         backquoted(element.name()) + " without the attribute " + backquoted(name));
    }
    return found.value();
  }

  void part(pugi::xml_node element) {
    if (is(element, "componentInstance") || is(element, "mplModel")) return instance(element);
    if (is(element, "mplHarness")) {
      for (const pugi::xml_node& child : element.children()) {
        if (is(child, "obs")) model_.observed.emplace_back(attribute(child, "name"), span(child));
        if (is(child, "cmd")) model_.commanded.emplace_back(attribute(child, "name"), span(child));
      }
      return;
    }
    if (is(element, "mplInit")) {
      for (const pugi::xml_node& child : element.children()) {
        if (is(child, "assign")) model_.initial.emplace_back(attribute(child, "eq"), span(child));
      }
      return;
    }
    refuse(element, backquoted(element.name()) + " is no part of a Livingstone2 model that is known here");
  }

  void instance(pugi::xml_node element) {
    if (model_.name.empty()) model_.name = element.attribute("name").value();
    for (const pugi::xml_node& child : element.children()) {
      if (is(child, "attributetype") || is(child, "type")) {
        model_.types[attribute(child, "name")] = words(attribute(child, "members"));
      } else if (is(child, "component")) {
        component(child);
      } else {
        refuse(child, backquoted(child.name()) + " in an instance has no counterpart in a plant");
      }
    }
  }

  void component(pugi::xml_node element) {
    XmplComponent& made = model_.components.emplace_back();
    made.name = attribute(element, "name");
    made.type = attribute(element, "type");
    made.place = span(element);
    for (const pugi::xml_node& child : element.children()) {
      if (is(child, "statevector")) {
        const std::vector<std::string> variables = words(attribute(child, "vars"));
        if (variables.size() > 1)
          refuse(child, "a component with several state variables has no counterpart: a mode is one");
        if (variables.size() == 1) made.state = variables.front();
      } else if (is(child, "attribute")) {
        made.attributes.push_back({attribute(child, "name"), attribute(child, "type"), span(child)});
        part_of_harness(child, made);
      } else if (is(child, "clause")) {
        made.clauses.push_back(clause(child));
      } else if (is(child, "transition")) {
        transition(child, made);
      } else if (!is(child, "struct")) {  // names of parts that have been flattened already
        refuse(child, backquoted(child.name()) + " in a component has no counterpart in a plant");
      }
    }
  }

  /// What the attribute read last is to the outside, where the model says so itself.
  void part_of_harness(pugi::xml_node element, XmplComponent& component) {
    const std::string_view role = element.attribute("interface").value();
    const std::string& own = component.attributes.back().name;
    if (role == "state") component.state = own;
    if (role == "cmd" || role == "command") model_.commanded.emplace_back(component.name + "." + own, span(element));
    if (role == "obs" || role == "monitor") model_.observed.emplace_back(component.name + "." + own, span(element));
  }

  void transition(pugi::xml_node element, XmplComponent& component) {
    XmplTransition& made = component.transitions.emplace_back();
    made.from = attribute(element, "from");
    made.to = attribute(element, "to");
    made.place = span(element);
    const std::string_view other = element.attribute("var").value();
    if (!other.empty() && !component.state.empty() && other != component.state &&
        other != component.name + "." + component.state) {
      refuse(element, "a transition of a variable other than the mode has no counterpart");
    }
    for (const char* name : {"probability", "prob"}) {
      if (element.attribute(name)) made.probability = probability(element, element.attribute(name).value());
    }
    for (const pugi::xml_node& child : element.children()) {
      if (is(child, "clause")) made.clauses.push_back(clause(child));
    }
  }

  double probability(pugi::xml_node element, const std::string& text) {
    for (const auto& [name, rank] : ranks) {
      if (text == name) return std::pow(10.0, -rank);
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value > 0) || value > 1) {
      diagnostics_.error(Code::netlist_syntax, span(element),
                         backquoted(text) +
                             " is no probability above 0, and none of likely, lessLikely, unlikely, rare "
                             "and unknownFaultRank");
    }
    return value;
  }

  XmplClause clause(pugi::xml_node element) {
    XmplClause made;
    made.place = span(element);
    for (const std::string& text : words(element.attribute("disj").value())) term(element, text, made);
    for (const pugi::xml_node& child : element.children()) {
      if (!is(child, "term")) continue;
      const pugi::xml_attribute text = child.attribute("disj");
      term(child, text ? text.value() : child.child_value(), made);
    }
    return made;
  }

  void term(pugi::xml_node element, std::string_view text, XmplClause& clause) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
    XmplTerm made;
    made.negated = text.starts_with('!');
    if (made.negated) text.remove_prefix(1);
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == text.size()) {
      diagnostics_.error(Code::netlist_syntax, span(element), "expected a term `a=b` or `!a=b`");
      return;
    }
    made.left = text.substr(0, equals);
    made.right = text.substr(equals + 1);
    clause.terms.push_back(std::move(made));
  }

  std::string_view text_;
  std::uint32_t index_;
  XmplModel& model_;
  grammar::Diagnostics& diagnostics_;
};

}  // namespace

bool read_xmpl(const grammar::Sources& sources, std::uint32_t file, XmplModel& model,
               grammar::Diagnostics& diagnostics) {
  return XmplReader(sources[file], file, model, diagnostics).run();
}

}  // namespace rmpl::compiler
