// System catalogues of the diagnostic competition: XML with components and connections between their pins.
//
// Everything that is not a gate only joins pins: wires, probes, ports, and the names that connections mention without
// declaring them. Joined pins are one net (union-find).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <pugixml.hpp>
#include <unordered_map>
#include <utility>

#include "automata/error.hpp"
#include "compiler/import/netlist.hpp"

namespace compiler {
namespace {

constexpr std::array<std::pair<std::string_view, GateFunction>, 7> functions{
    {{"and", GateFunction::conjunction},
     {"nand", GateFunction::negated_conjunction},
     {"or", GateFunction::disjunction},
     {"nor", GateFunction::negated_disjunction},
     {"xor", GateFunction::exclusive},
     {"inverter", GateFunction::negation},
     {"buffer", GateFunction::buffer}}};

class CatalogueReader {
 public:
  explicit CatalogueReader(const std::string& file) : file_(file) {}

  Netlist run(std::string_view text) {
    pugi::xml_document document;
    const auto parsed = document.load_buffer(text.data(), text.size());
    if (!parsed) fail(std::string("no XML: ") + parsed.description() + " at byte " + std::to_string(parsed.offset));
    const auto system = document.child("systemCatalog").child("systems").child("system");
    if (!system) fail("expected systemCatalog/systems/system");
    Netlist netlist;
    netlist.name = system.child_value("systemName");
    for (const auto& connection : system.child("connections").children("connection")) {
      join(pin(connection.child_value("c1")), pin(connection.child_value("c2")));
    }
    std::vector<std::string> ports;
    for (const auto& component : system.child("components").children("component")) {
      const std::string name = component.child_value("name");
      const std::string type = component.child_value("componentType");
      if (type == "port") ports.push_back(name);
      const auto* known = std::find_if(functions.begin(), functions.end(), [&](const auto& f) {
        return type.compare(0, f.first.size(), f.first) == 0 &&
               std::all_of(type.begin() + static_cast<std::ptrdiff_t>(f.first.size()), type.end(),
                           [](unsigned char c) { return std::isdigit(c) != 0; });
      });
      if (known != functions.end()) netlist.gates.push_back(gate(name, known->second));
    }
    if (netlist.gates.empty()) fail("a system without gates");
    finish(netlist, ports);
    return netlist;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw automata::InputError(file_ + ":1:1: error: " + message);
  }

  std::size_t pin(const std::string& name) {
    if (name.empty()) fail("a connection without c1 or c2");
    const auto [at, fresh] = pins_.try_emplace(name, parent_.size());
    if (fresh) parent_.push_back(at->second);
    return at->second;
  }
  std::size_t root(std::size_t p) {
    while (parent_[p] != p) p = parent_[p] = parent_[parent_[p]];
    return p;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

  Gate gate(const std::string& name, GateFunction function) {
    Gate result{name, function, {}, pin(name + ".o")};
    for (std::size_t i = 1; pins_.contains(name + ".i" + std::to_string(i)); ++i) {
      result.inputs.push_back(pins_.at(name + ".i" + std::to_string(i)));
    }
    if (result.inputs.empty()) fail("the gate '" + name + "' has no connected input");
    return result;
  }

  /// Pins become nets; a port is an output where a gate drives it, else an input.
  void finish(Netlist& netlist, const std::vector<std::string>& ports) {
    std::map<std::size_t, Net> nets;
    const auto net = [&](std::size_t p) { return nets.try_emplace(root(p), nets.size()).first->second; };
    std::map<Net, std::string> driver;
    for (Gate& g : netlist.gates) {
      for (Net& input : g.inputs) input = net(input);
      g.output = net(g.output);
      const auto [at, fresh] = driver.try_emplace(g.output, g.name);
      if (!fresh) fail("'" + at->second + "' and '" + g.name + "' drive one net");
    }
    for (const std::string& port : ports) {
      const Net on = net(pin(port));  // a port that nothing is connected to has a net of its own
      (driver.contains(on) ? netlist.outputs : netlist.inputs).push_back({port, on});
      driver.try_emplace(on, port);
    }
    netlist.nets = nets.size();
    for (const Gate& g : netlist.gates) {
      for (const Net input : g.inputs) {
        if (!driver.contains(input)) fail("nothing drives an input of '" + g.name + "'");
      }
    }
  }

  const std::string& file_;
  std::unordered_map<std::string, std::size_t> pins_;
  std::vector<std::size_t> parent_;
};

}  // namespace

Netlist read_catalogue(std::string_view text, const std::string& file) { return CatalogueReader(file).run(text); }

}  // namespace compiler
