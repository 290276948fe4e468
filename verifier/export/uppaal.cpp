// Networks for UPPAAL, as XML after its flat-1_2 document type: a template for each kind of component.
//
// In a round the components have their turns, first to step, then to rest; `m` has the modes as it begins, `n` as it
// ends. No time passes in it, as the template of rounds is in an urgent location. Components whose templates would read
// the same, but for which components and controls they read, are instances of one.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "automata/controls.hpp"
#include "base/error.hpp"
#include "verifier/export/condition_text.hpp"
#include "verifier/export/write.hpp"

namespace rmpl::verifier {

using automata::ModeId;
using automata::Plant;
using automata::VariableId;

namespace {

/// UPPAAL's clocks are compared with 32-bit integers, one bit of which tells strict from weak.
constexpr Units greatest = (Units{1} << 30) - 1;

std::string constant(Units units) {
  if (units <= greatest) return std::to_string(units);
  throw base::InputError("uppaal: a time bound of " + std::to_string(units) +
                         " units is beyond its integers; expected coarser or shorter bounds");
}

void add(std::string& text, const char* separator, const std::string& part) {
  if (part.empty() || part == "true") return;
  text += (text.empty() ? "" : separator) + part;
}

std::string condition(const Interval& range) {
  std::string result;
  if (range.lower > 0) add(result, " && ", "x >= " + constant(range.lower));
  if (range.upper != unbounded) add(result, " && ", "x <= " + constant(range.upper));
  return result;
}

/// In parentheses where it would fall apart in a conjunction.
std::string operand(const std::string& condition) {
  return condition.find("||") == std::string::npos ? condition : "(" + condition + ")";
}

void add_text(pugi::xml_node parent, const char* name, const std::string& text) {
  parent.append_child(name).text().set(text.c_str());
}

void add_label(pugi::xml_node parent, const char* kind, const std::string& text) {
  if (text.empty()) return;
  pugi::xml_node label = parent.append_child("label");
  label.append_attribute("kind") = kind;
  label.text().set(text.c_str());
}

/// A template on its way: locations first, as the document type has it, then edges.
class Template {
 public:
  explicit Template(pugi::xml_node node) : node_(node) {}

  std::string add_location(const std::string& name, const std::string& invariant = {}, bool urgent = false) {
    std::string id = "id" + std::to_string(locations_++);
    pugi::xml_node node = node_.append_child("location");
    node.append_attribute("id") = id.c_str();
    add_text(node, "name", name);
    add_label(node, "invariant", invariant);
    if (urgent) node.append_child("urgent");
    return id;
  }
  void set_initial(const std::string& id) { node_.append_child("init").append_attribute("ref") = id.c_str(); }
  void add_edge(const std::string& from, const std::string& to, const std::string& guard, const std::string& effect) {
    pugi::xml_node node = node_.append_child("transition");
    node.append_child("source").append_attribute("ref") = from.c_str();
    node.append_child("target").append_attribute("ref") = to.c_str();
    add_label(node, "guard", guard);
    add_label(node, "assignment", effect);
  }

 private:
  pugi::xml_node node_;
  std::size_t locations_ = 0;
};

/// What an instance of a template is given: the components and controls that it reads, in the order in which its
/// template mentions them.
class Parameters {
 public:
  Parameters(const Plant& plant, std::size_t self) : plant_(plant), self_(self) {}

  /// `m[a0]`, `n[a0]` or `u[c0]`.
  std::string name_of(VariableId variable, const char* modes) {
    if (const auto component = plant_.component_of(variable)) {
      if (component->index() == self_) return std::string(modes) + "[i]";
      return std::string(modes) + "[" + numbered('a', component->index(), components_) + "]";
    }
    return "u[" + numbered('c', *automata::control_of(plant_, variable), controls_) + "]";
  }
  [[nodiscard]] std::string declared() const {
    std::string text = "const int i";
    for (std::size_t a = 0; a < components_.size(); ++a) text += ", const int a" + std::to_string(a);
    for (std::size_t c = 0; c < controls_.size(); ++c) text += ", const int c" + std::to_string(c);
    return text;
  }
  [[nodiscard]] std::string given() const {
    std::string text = std::to_string(self_);
    for (const std::size_t component : components_) text += ", " + std::to_string(component);
    for (const std::size_t control : controls_) text += ", " + std::to_string(control);
    return text;
  }

 private:
  static std::string numbered(char letter, std::size_t what, std::vector<std::size_t>& list) {
    const auto known = std::find(list.begin(), list.end(), what);
    const auto position = known - list.begin();
    if (known == list.end()) list.push_back(what);
    return letter + std::to_string(position);
  }

  const Plant& plant_;
  std::size_t self_;
  std::vector<std::size_t> components_, controls_;
};

class Writer {
 public:
  Writer(const Plant& plant, const Network& network) : plant_(plant), network_(network) {}

  void run(std::ostream& out) {
    pugi::xml_document document;
    pugi::xml_node header = document.append_child(pugi::node_declaration);
    header.append_attribute("version") = "1.0";
    header.append_attribute("encoding") = "utf-8";
    document.append_child(pugi::node_doctype)
        .set_value(
            "nta PUBLIC '-//Uppaal Team//DTD Flat System 1.2//EN' "
            "'http://www.it.uu.se/research/group/darts/uppaal/flat-1_2.dtd'");
    pugi::xml_node system = document.append_child("nta");
    add_text(system, "declaration", declarations());
    std::string instances, names;
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      const std::string name = "p" + std::to_string(c) + "_" + identifier(plant_.components[c].name);
      instances += name + " = " + instance_of(system, c) + ";\n";
      names += ", " + name;
    }
    rounds(system);
    add_text(system, "system", instances + "system Rounds" + names + ";");
    pugi::xml_node query = system.append_child("queries").append_child("query");
    add_text(query, "formula", "E<> reached");
    add_text(query, "comment", "satisfied where the target is reachable, or the forbidden formula can hold");
    document.save(out, " ");
  }

 private:
  [[nodiscard]] std::size_t count() const { return plant_.components.size(); }
  [[nodiscard]] std::string last_turn() const { return std::to_string(2 * count() + 1); }

  std::string declarations() const {
    std::size_t modes = 1;
    for (const automata::Component& component : plant_.components) modes = std::max(modes, component.modes.size());
    const std::string size = "[" + std::to_string(count()) + "]";
    const std::string range = "int[0, " + std::to_string(modes - 1) + "] ";
    std::string text = "// " + plant_.name + "; 1 unit of time is " + automata::format_seconds(network_.time.unit()) +
                       " s\nbool reached = false;\nint[0, " + last_turn() + "] turn = 0;\n" + range + "m" + size +
                       "; // modes as a round begins\n" + range + "n" + size + "; // and as it ends\n";
    if (network_.faults > 0) text += "int[0, " + std::to_string(network_.faults) + "] faults = 0;\n";
    if (plant_.controls.empty()) return text;
    std::size_t values = 1;
    std::string idle;
    for (const automata::Control& control : plant_.controls) {
      values = std::max(values, plant_.variables[control.variable].values.size());
      idle += (idle.empty() ? "" : ", ") + std::to_string(control.idle.index());
    }
    text += "int[0, " + std::to_string(values - 1) + "] u[" + std::to_string(plant_.controls.size()) + "] = { " + idle +
            " }; // controls, in order:\n//";
    for (const automata::Control& control : plant_.controls) text += " " + plant_.variables.name(control.variable);
    return text + "\nbool commanded = false;\n";
  }

  /// The template of a component with what it is given; a new one where none is like it.
  std::string instance_of(pugi::xml_node system, std::size_t c) {
    Parameters parameters(plant_, c);
    pugi::xml_document document;
    fill(document.append_child("body"), c, parameters);
    std::ostringstream body;
    document.save(body, "", pugi::format_raw | pugi::format_no_declaration);
    const auto [known, fresh] = templates_.emplace(std::pair(body.str(), parameters.declared()), "");
    if (fresh) {
      const std::string type = identifier(plant_.components[c].type);
      const std::size_t same = types_[type]++;
      known->second = same == 0 ? type + "_t" : type + "_t" + std::to_string(same + 1);
      pugi::xml_node made = system.append_child("template");
      add_text(made, "name", known->second);
      add_text(made, "parameter", parameters.declared());
      if (network_.processes[c].clocked) add_text(made, "declaration", "clock x; // since it entered its mode");
      for (const pugi::xml_node& part : document.child("body")) made.append_copy(part);
    }
    return known->second + "(" + parameters.given() + ")";
  }

  void fill(pugi::xml_node node, std::size_t c, Parameters& parameters) {
    const automata::Component& component = plant_.components[c];
    const ComponentProcess& process = network_.processes[c];
    Template made(node);
    const std::string start = made.add_location("start");
    std::vector<std::string> awake, stopped(component.modes.size());
    for (std::size_t m = 0; m < component.modes.size(); ++m) awake.push_back(made.add_location(name_of(component, m)));
    std::vector<std::string> rests;
    for (const ProcessRest& rest : process.rests) {
      const std::string name = name_of(component, rest.mode.index());
      std::string& halt = stopped[rest.mode.index()];
      if (rest.urgent) {
        if (halt.empty()) halt = made.add_location(name + "_stopped", "", true);
        rests.push_back(halt);
        continue;
      }
      rests.push_back(made.add_location(name + "_rests" + std::to_string(rests.size()),
                                        rest.restarts ? std::string() : condition({0, rest.clock.upper})));
    }
    made.set_initial(start);
    const std::string mine = "turn == i";
    const std::string next = "turn = i + 1";
    for (const ModeId mode : process.initial) {
      made.add_edge(start, awake[mode.index()], mine, "n[i] = " + std::to_string(mode.value) + ", " + next);
    }
    wake(made, process, rests, stopped, awake);
    for (const ProcessStep& step : process.steps) {
      std::string guard = mine;
      add(guard, " && ",
          operand(condition_text(step.where, plant_, [&](VariableId v) { return parameters.name_of(v, "m"); })));
      add(guard, " && ", condition(step.clock));
      std::string effect = "n[i] = " + std::to_string(step.to.value);
      if (step.fault) {
        add(guard, " && ", "faults < " + std::to_string(network_.faults));
        add(effect, ", ", "faults++");
      }
      if (step.restarts) add(effect, ", ", "x = 0");
      add(effect, ", ", next);
      made.add_edge(awake[step.from.index()], awake[step.to.index()], guard, effect);
    }
    const std::string settling = "turn == i + " + std::to_string(count() + 1);
    for (std::size_t r = 0; r < process.rests.size(); ++r) {
      const ProcessRest& rest = process.rests[r];
      std::string guard = settling;
      add(guard, " && ",
          operand(condition_text(rest.where, plant_, [&](VariableId v) { return parameters.name_of(v, "n"); })));
      add(guard, " && ", condition(rest.clock));
      made.add_edge(awake[rest.mode.index()], rests[r], guard,
                    "m[i] = " + std::to_string(rest.mode.value) + (rest.restarts ? ", x = 0" : "") + ", turn++");
    }
  }

  /// Edges out of every place where it rests, each place once.
  static void wake(Template& made, const ComponentProcess& process, const std::vector<std::string>& rests,
                   const std::vector<std::string>& stopped, const std::vector<std::string>& awake) {
    for (std::size_t r = 0; r < rests.size(); ++r) {
      if (process.rests[r].urgent) continue;
      const bool restarts = process.rests[r].restarts;
      made.add_edge(rests[r], awake[process.rests[r].mode.index()], restarts ? "turn == i && x >= 1" : "turn == i",
                    restarts ? "x = 0" : "");
    }
    for (std::size_t m = 0; m < stopped.size(); ++m) {
      if (!stopped[m].empty()) made.add_edge(stopped[m], awake[m], "turn == i", "");
    }
  }

  /// Unique: a number follows the name.
  static std::string name_of(const automata::Component& component, std::size_t mode) {
    return identifier(component.modes[mode].name) + "_" + std::to_string(mode);
  }

  /// Who has the turn, what is commanded, and what came of a round.
  void rounds(pugi::xml_node system) {
    pugi::xml_node node = system.append_child("template");
    add_text(node, "name", "Rounds");
    Template made(node);
    const std::string rest = made.add_location("rest");
    const std::string round = made.add_location("round", "", true);
    made.set_initial(round);
    made.add_edge(rest, round, "", "turn = 0");
    for (std::size_t c = 0; c < plant_.controls.size() && network_.commands != Commands::none; ++c) {
      const automata::Control& control = plant_.controls[c];
      const std::string u = "u[" + std::to_string(c) + "]";
      std::string guard = "turn == 0 && " + u + " == " + std::to_string(control.idle.index());
      if (network_.commands == Commands::one) guard += " && !commanded";
      for (std::size_t v = 0; v < plant_.variables[control.variable].values.size(); ++v) {
        if (v == control.idle.index()) continue;
        made.add_edge(round, round, guard, u + " = " + std::to_string(v) + ", commanded = true");
      }
    }
    const auto name = [&](VariableId v) { return "n[" + std::to_string(plant_.component_of(v)->index()) + "]"; };
    std::string possible = "turn == " + std::to_string(count());
    for (const automata::Formula& one : network_.possible) {
      add(possible, " && ", operand(condition_text(one, plant_, name)));
    }
    made.add_edge(round, round, possible, "turn++");
    std::string effect = "reached = " + condition_text(network_.target, plant_, name);
    for (std::size_t c = 0; c < plant_.controls.size(); ++c) {
      effect += ", u[" + std::to_string(c) + "] = " + std::to_string(plant_.controls[c].idle.index());
    }
    if (!plant_.controls.empty()) effect += ", commanded = false";
    made.add_edge(round, rest, "turn == " + last_turn(), effect);
  }

  const Plant& plant_;
  const Network& network_;
  std::map<std::pair<std::string, std::string>, std::string> templates_;  ///< names, by body and parameters
  std::map<std::string, std::size_t> types_;                              ///< templates so far, by type
};

}  // namespace

void write_uppaal(std::ostream& out, const Plant& plant, const Network& network) { Writer(plant, network).run(out); }

}  // namespace rmpl::verifier
