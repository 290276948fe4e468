// A Livingstone2 model as a plant: clauses are sorted to the modes in which they say something.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <iterator>
#include <set>
#include <tuple>

#include "automata/time/time.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/import/netlist.hpp"
#include "compiler/import/xmpl.hpp"

namespace rmpl::compiler {
namespace {

using grammar::Code;
using grammar::Span;

constexpr const char* no_command = "noCommand";

/// Conjunctions or disjunctions in the notation of constraints; the brackets that they need come with them.
std::string joined(const std::vector<std::string>& parts, const char* sign) {
  if (parts.size() == 1) return parts.front();
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "(" : sign) + part;
  return text + ")";
}

class XmplWriter {
 public:
  XmplWriter(const XmplModel& model, grammar::Diagnostics& diagnostics) : model_(model), diagnostics_(diagnostics) {}

  std::optional<std::string> run() {
    const std::size_t errors = diagnostics_.error_count();
    for (const XmplComponent& component : model_.components) declare(component);
    for (const auto& [name, place] : model_.commanded) {
      if (type_of(name, place) != nullptr) commanded_.insert(name);
    }
    read_start();
    std::string types, instances;
    for (const XmplComponent& component : model_.components) {
      if (component.state.empty()) {
        module(component);
        continue;
      }
      const std::string body = body_of(component);
      const std::string type = type_name(component.type, body, types);
      const std::string initial = start_of(component);
      instances += "  " + name(component.name, component.place) + " : " + type +
                   (initial.empty() ? "" : " { initial " + initial + "; }") + ";\n";
    }
    if (diagnostics_.error_count() != errors) return std::nullopt;
    return "// Imported from a Livingstone2 model. A rank r became the probability 10^-r.\n" + domains() + types +
           "\nplant " + name(model_.name.empty() ? "model" : model_.name, {}) + " {\n" + attributes_ + instances +
           "\n" + connections_ + harness() + "}\n";
  }

 private:
  using Type = std::vector<std::string>;

  std::string name(const std::string& text, Span place) {
    if (auto made = identifier_of(text); made && *made == text) return text;
    if (auto made = identifier_of(text)) return *made;
    diagnostics_.error(Code::netlist_syntax, place,
                       backquoted(text) + " cannot be made a name: " + std::string(names_that_can_be_said));
    return "_";
  }

  /// A variable by its path: the attribute is named as its component declares it.
  std::string path(const std::string& text, Span place) {
    const std::size_t point = text.rfind('.');
    if (point == std::string::npos) return name(text, place);
    return name(text.substr(0, point), place) + "." + name(text.substr(point + 1), place);
  }

  void declare(const XmplComponent& component) {
    for (const XmplAttribute& attribute : component.attributes) {
      if (!model_.types.contains(attribute.type)) {
        diagnostics_.error(Code::unknown_name, attribute.place, "there is no type " + backquoted(attribute.type));
        continue;
      }
      variables_[component.name + "." + attribute.name] = attribute.type;
    }
    if (!component.state.empty()) modes_.insert(component.name + "." + component.state);
  }

  /// The domain of a variable in full; null where it is not there, which has been reported.
  const Type* type_of(const std::string& variable, Span place) {
    const auto found = variables_.find(variable);
    if (found != variables_.end()) return &model_.types.at(found->second);
    diagnostics_.error(Code::unknown_name, place, "there is no variable " + backquoted(variable));
    return nullptr;
  }

  void read_start() {
    for (const auto& [text, place] : model_.initial) {
      const std::size_t equals = text.find('=');
      if (equals == std::string::npos) {
        diagnostics_.error(Code::netlist_syntax, place, "expected an assignment `name=value`");
        continue;
      }
      const std::string variable = text.substr(0, equals);
      if (type_of(variable, place) != nullptr) initial_[variable] = {text.substr(equals + 1), place};
    }
  }

  /// The variable that a clause of the component names: one of its own or of its parts, or, in full, of any.
  std::string in_full(const std::string& variable, const XmplComponent& scope) const {
    std::string own = scope.name + "." + variable;
    return variables_.contains(own) || !variables_.contains(variable) ? own : variable;
  }

  /// A variable in full, as it is called where the clause stands: in the plant, where a mode has the name of its
  /// component, or in the component.
  std::string called(const std::string& variable, const XmplComponent& scope, Span place, bool full) {
    if (full && modes_.contains(variable)) return name(variable.substr(0, variable.rfind('.')), place);
    if (full) return path(variable, place);
    if (variable.starts_with(scope.name + ".")) return name(variable.substr(scope.name.size() + 1), place);
    diagnostics_.error(Code::netlist_gate, place,
                       "component " + backquoted(scope.name) + " reads " + backquoted(variable) +
                           " of another component, which has no counterpart");
    return "_";
  }

  /// A term relative to `scope`; what it says of `mode`, the state of the component at hand, is decided: true or false
  /// as a text is "true" or "false".
  std::string term(const XmplTerm& term, const XmplComponent& scope, const std::string* mode, Span place, bool full) {
    const std::string left = in_full(term.left, scope);
    if (mode != nullptr && left == scope.name + "." + scope.state) {
      return (term.right == *mode) != term.negated ? "true" : "false";
    }
    const Type* type = type_of(left, place);
    if (type == nullptr) return "true";
    const std::string shown = called(left, scope, place, full);
    const char* sign = term.negated ? " != " : " = ";
    if (std::find(type->begin(), type->end(), term.right) != type->end()) return shown + sign + name(term.right, place);
    const std::string right = in_full(term.right, scope);
    if (type_of(right, place) == nullptr) return "true";
    return shown + sign + called(right, scope, place, full);
  }

  /// The clause, in a mode where one is given; empty where it says nothing there.
  std::string clause(const XmplClause& clause, const XmplComponent& scope, const std::string* mode, bool full) {
    std::vector<std::string> terms;
    for (const XmplTerm& one : clause.terms) {
      const std::string text = term(one, scope, mode, clause.place, full);
      if (text == "true") return "";
      if (text != "false") terms.push_back(text);
    }
    return terms.empty() ? "false" : joined(terms, " | ");
  }

  /// Where the transition happens: in some clause no term holds. Empty: everywhere.
  std::string guard(const XmplTransition& transition, const XmplComponent& scope) {
    std::vector<std::string> ways;
    for (const XmplClause& clause : transition.clauses) {
      std::vector<std::string> all;
      for (XmplTerm one : clause.terms) {
        one.negated = !one.negated;
        const std::string text = term(one, scope, &transition.from, clause.place, false);
        if (text != "true") all.push_back(text);
      }
      if (all.empty()) return "";
      ways.push_back(joined(all, " & "));
    }
    return ways.empty() ? "" : joined(ways, " | ");
  }

  static std::string number(double value) {
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
  }

  std::string body_of(const XmplComponent& component) {
    const auto state = std::find_if(component.attributes.begin(), component.attributes.end(),
                                    [&](const XmplAttribute& a) { return a.name == component.state; });
    if (state == component.attributes.end() || !model_.types.contains(state->type)) {
      diagnostics_.error(Code::unknown_name, component.place,
                         "component " + backquoted(component.name) + " does not declare its state variable " +
                             backquoted(component.state));
      return "";
    }
    const Type& modes = model_.types.at(state->type);
    std::string text;
    for (const XmplAttribute& attribute : component.attributes) {
      if (&attribute == &*state || !model_.types.contains(attribute.type)) continue;
      const bool commanded = commanded_.contains(component.name + "." + attribute.name);
      text += std::string("  ") + (commanded ? "input  " : "output ") + name(attribute.name, attribute.place) + " : " +
              name(attribute.type, attribute.place) + ";\n";
      used_.insert(attribute.type);
    }
    const auto is_fault = [&](const std::string& mode) {
      return std::any_of(component.transitions.begin(), component.transitions.end(),
                         [&](const XmplTransition& t) { return t.to == mode && t.probability; });
    };
    const auto first = std::find_if_not(modes.begin(), modes.end(), is_fault);
    if (first == modes.end()) {
      diagnostics_.error(Code::netlist_gate, component.place,
                         "every mode of component " + backquoted(component.name) + " is a failure: it has no start");
      return "";
    }
    text += "  initial " + name(*first, component.place) + ";\n";
    for (const std::string& mode : modes) {
      std::vector<std::string> all;
      for (const XmplClause& one : component.clauses) {
        if (std::string said = clause(one, component, &mode, false); !said.empty()) all.push_back(std::move(said));
      }
      text += std::string("  ") + (is_fault(mode) ? "fault " : "mode  ") + name(mode, component.place);
      if (!all.empty()) {
        const std::string constraint = joined(all, " & ");
        const bool bracketed = all.size() > 1;
        text += " { " + (bracketed ? constraint.substr(1, constraint.size() - 2) : constraint) + " }";
      }
      text += ";\n";
    }
    for (const XmplTransition& transition : component.transitions) text += transition_of(transition, component, modes);
    return text;
  }

  std::string transition_of(const XmplTransition& transition, const XmplComponent& component, const Type& modes) {
    const auto has = [&](const std::string& mode) {
      return std::find(modes.begin(), modes.end(), mode) != modes.end();
    };
    for (const std::string& mode : {transition.from, transition.to}) {
      if (mode == "*" && &mode != &transition.to) continue;
      if (has(mode)) continue;
      diagnostics_.error(Code::unknown_name, transition.place,
                         "component " + backquoted(component.name) + " has no mode " + backquoted(mode));
      return "";
    }
    // Where no transition is enabled a component stays: Livingstone2 says so of each mode.
    if (transition.from == transition.to) return "";
    std::string from;
    for (const std::string& mode : modes) {
      const bool leaves = transition.from == "*" ? mode != transition.to : mode == transition.from;
      if (leaves) from += (from.empty() ? "" : ", ") + name(mode, transition.place);
    }
    if (from.empty()) return "";
    const std::string when = guard(transition, component);
    return "  " + from + " -> " + name(transition.to, transition.place) + (when.empty() ? "" : " when " + when) +
           (transition.probability ? " with " + number(*transition.probability) : "") + ";\n";
  }

  /// What has no state holds its parts: its attributes are the plant's, and what it says connects them.
  void module(const XmplComponent& component) {
    for (const XmplAttribute& attribute : component.attributes) {
      if (!model_.types.contains(attribute.type)) continue;
      attributes_ += "  internal " + path(component.name + "." + attribute.name, attribute.place) + " : " +
                     name(attribute.type, attribute.place) + ";\n";
      used_.insert(attribute.type);
    }
    for (const XmplClause& one : component.clauses) {
      if (const std::string said = clause(one, component, nullptr, true); !said.empty())
        connections_ += "  " + said + ";\n";
    }
    for (const XmplTransition& transition : component.transitions) {
      diagnostics_.error(Code::netlist_gate, transition.place, "a transition of a component without a state variable");
    }
  }

  /// Components that are alike share a type; others of its name get a number.
  std::string type_name(const std::string& type, const std::string& body, std::string& types) {
    const auto known = types_.find({type, body});
    if (known != types_.end()) return known->second;
    std::string made = name(type, {});
    while (!taken_.insert(made).second) made = name(type, {}) + "-" + std::to_string(++copies_[type] + 1);
    types_[{type, body}] = made;
    types += "\ncomponent " + made + " {\n" + body + "}\n";
    return made;
  }

  std::string start_of(const XmplComponent& component) {
    const auto found = initial_.find(component.name + "." + component.state);
    if (found == initial_.end()) return "";
    const auto& [mode, place] = found->second;
    const Type* modes = type_of(found->first, place);
    if (modes != nullptr && std::find(modes->begin(), modes->end(), mode) == modes->end()) {
      diagnostics_.error(Code::value_outside_domain, place,
                         backquoted(mode) + " is no mode of component " + backquoted(component.name));
    }
    return name(mode, place);
  }

  std::string domains() const {
    std::string text = "\n";
    for (const std::string& type : used_) {
      Type values = model_.types.at(type);
      // What is commanded where nothing is comes first, as in Livingstone2.
      std::stable_partition(values.begin(), values.end(), [](const std::string& v) { return v == no_command; });
      text += "domain " + identifier_of(type).value_or("_") + " = { ";
      for (std::size_t v = 0; v < values.size(); ++v)
        text += (v == 0 ? "" : ", ") + identifier_of(values[v]).value_or("_");
      text += " };\n";
    }
    return text;
  }

  std::string harness() {
    std::string text;
    for (const auto& [variable, place] : model_.commanded) {
      const Type* type = type_of(variable, place);
      if (type == nullptr) continue;
      const bool idle = std::find(type->begin(), type->end(), no_command) != type->end();
      if (!idle) {
        diagnostics_.warning(
            Code::no_default, place,
            "the domain of " + backquoted(variable) + " has no `noCommand`: its first value is taken for idle");
      }
      text +=
          "  control " + path(variable, place) + " default " + name(idle ? no_command : type->front(), place) + ";\n";
    }
    for (const auto& [variable, place] : model_.observed) {
      if (type_of(variable, place) != nullptr) text += "  observe " + path(variable, place) + ";\n";
    }
    return text;
  }

  const XmplModel& model_;
  grammar::Diagnostics& diagnostics_;
  std::map<std::string, std::string> variables_;  ///< in full, with their types
  std::set<std::string> modes_;                   ///< variables that are modes of components
  std::set<std::string> commanded_;
  std::map<std::string, std::pair<std::string, Span>> initial_;
  std::map<std::pair<std::string, std::string>, std::string> types_;  ///< names of types by name and body
  std::set<std::string> taken_;
  std::map<std::string, int> copies_;
  std::set<std::string> used_;  ///< domains
  std::string attributes_, connections_;
};

}  // namespace

std::optional<std::string> to_tcca(const XmplModel& model, grammar::Diagnostics& diagnostics) {
  return XmplWriter(model, diagnostics).run();
}

}  // namespace rmpl::compiler
