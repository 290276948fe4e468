// Timed automata for UPPAAL, as XML after its flat-1_2 document type.
// SPDX-License-Identifier: MIT
#include <pugixml.hpp>
#include <string>

#include "base/error.hpp"
#include "verifier/export/write.hpp"

namespace rmpl::verifier {

namespace {

/// UPPAAL's clocks are compared with 32-bit integers, one bit of which tells strict from weak.
constexpr Units greatest = (Units{1} << 30) - 1;

std::string constant(Units units) {
  if (units <= greatest) return std::to_string(units);
  throw base::InputError("uppaal: a time bound of " + std::to_string(units) +
                         " units is beyond its integers; expected coarser or shorter bounds");
}

std::string clock(std::size_t number) { return "x[" + std::to_string(number) + "]"; }

void add(std::string& text, const char* separator, const std::string& part) {
  text += (text.empty() ? "" : separator) + part;
}

std::string conditions(const std::vector<ClockRange>& ranges) {
  std::string result;
  for (const auto& [number, range] : ranges) {
    if (range.lower > 0) add(result, " && ", clock(number) + " >= " + constant(range.lower));
    if (range.upper != unbounded) add(result, " && ", clock(number) + " <= " + constant(range.upper));
  }
  return result;
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

std::string id(std::size_t location) { return "id" + std::to_string(location); }

void add_location(pugi::xml_node parent, const std::string& number, const std::string& comment,
                  const std::string& invariant, bool urgent) {
  pugi::xml_node node = parent.append_child("location");
  node.append_attribute("id") = number.c_str();
  add_label(node, "invariant", invariant);
  add_label(node, "comments", comment);
  if (urgent) node.append_child("urgent");
}

void add_edge(pugi::xml_node parent, const std::string& from, const std::string& to, const std::string& guard,
              const std::string& effect) {
  pugi::xml_node node = parent.append_child("transition");
  node.append_child("source").append_attribute("ref") = from.c_str();
  node.append_child("target").append_attribute("ref") = to.c_str();
  add_label(node, "guard", guard);
  add_label(node, "assignment", effect);
}

/// Entering a location tells whether it is a target: UPPAAL has no labels to ask for.
std::string reached(const Location& location) {
  return std::string("reached = ") + (location.target ? "true" : "false");
}

void fill(pugi::xml_node process, const automata::Plant& plant, const TimedAutomaton& automaton) {
  add_text(process, "name", "P");
  for (std::size_t l = 0; l < automaton.locations.size(); ++l) {
    const Location& location = automaton.locations[l];
    add_location(process, id(l), describe(plant, location.modes), conditions(location.invariant), location.urgent);
  }
  add_location(process, "start", "the choice of an initial state", "", true);
  process.append_child("init").append_attribute("ref") = "start";
  for (const std::size_t l : automaton.initial) add_edge(process, "start", id(l), "", reached(automaton.locations[l]));
  for (const Edge& edge : automaton.edges) {
    std::string guard = conditions(edge.guard);
    std::string effect = reached(automaton.locations[edge.to]);
    for (const std::size_t reset : edge.resets) add(effect, ", ", clock(reset) + " = 0");
    if (edge.faults > 0) {
      const std::string faults = std::to_string(edge.faults);
      add(guard, " && ", "faults <= " + std::to_string(automaton.faults - edge.faults));
      add(effect, ", ", "faults = faults + " + faults);
    }
    add_edge(process, id(edge.from), id(edge.to), guard, effect);
  }
}

std::string declarations(const automata::Plant& plant, const TimedAutomaton& automaton) {
  std::string result = "// " + plant.name + "; 1 unit of time is " + automata::format_seconds(automaton.time.unit()) +
                       " s\nbool reached = false;\n";
  if (automaton.faults > 0) result += "int[0, " + std::to_string(automaton.faults) + "] faults = 0;\n";
  if (!automaton.clocks.empty()) result += "clock x[" + std::to_string(automaton.clocks.size()) + "];\n";
  for (std::size_t c = 0; c < automaton.clocks.size(); ++c) {
    result += "// " + clock(c) + ": time since " + plant[automaton.clocks[c]].name + " entered its mode\n";
  }
  return result;
}

}  // namespace

void write_uppaal(std::ostream& out, const automata::Plant& plant, const TimedAutomaton& automaton) {
  pugi::xml_document document;
  pugi::xml_node header = document.append_child(pugi::node_declaration);
  header.append_attribute("version") = "1.0";
  header.append_attribute("encoding") = "utf-8";
  document.append_child(pugi::node_doctype)
      .set_value(
          "nta PUBLIC '-//Uppaal Team//DTD Flat System 1.2//EN' "
          "'http://www.it.uu.se/research/group/darts/uppaal/flat-1_2.dtd'");
  pugi::xml_node system = document.append_child("nta");
  add_text(system, "declaration", declarations(plant, automaton));
  fill(system.append_child("template"), plant, automaton);
  add_text(system, "system", "system P;");
  pugi::xml_node query = system.append_child("queries").append_child("query");
  add_text(query, "formula", "E<> reached");
  add_text(query, "comment", "satisfied where the target is reachable, or what is never to hold can hold");
  document.save(out, "  ");
}

}  // namespace rmpl::verifier
