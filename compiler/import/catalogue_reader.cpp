// System catalogues of the diagnostic competition: XML with components and connections between their pins.
//
// Everything that is not a gate only joins pins: wires, probes, ports, and the names that connections mention without
// declaring them. Joined pins are one net (union-find).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "compiler/check/vocabulary.hpp"
#include "compiler/import/netlist.hpp"

namespace rmpl::compiler {
namespace {

using grammar::Code;
using grammar::Span;

constexpr std::array<std::pair<std::string_view, GateFunction>, 8> functions{
    {{"and", GateFunction::conjunction},
     {"nand", GateFunction::negated_conjunction},
     {"or", GateFunction::disjunction},
     {"nor", GateFunction::negated_disjunction},
     {"xor", GateFunction::exclusive},
     {"xnor", GateFunction::negated_exclusive},
     {"inverter", GateFunction::negation},
     {"buffer", GateFunction::buffer}}};

/// The function of `nand2` and the like; nothing for what is no gate.
std::optional<GateFunction> function_of(std::string_view type) {
  for (const auto& [name, function] : functions) {
    if (!type.starts_with(name)) continue;
    const std::string_view arity = type.substr(name.size());
    if (std::all_of(arity.begin(), arity.end(), [](unsigned char c) { return std::isdigit(c) != 0; })) return function;
  }
  return std::nullopt;
}

/// What drives a net, and where it is declared.
struct Driver {
  std::string name;
  Span place;
};

struct PlacedPort {
  std::string name;
  Span place;
};

class CatalogueReader {
 public:
  CatalogueReader(const grammar::SourceFile& file, std::uint32_t index, grammar::Diagnostics& diagnostics)
      : text_(file.text()), index_(index), errors_(diagnostics) {}

  std::optional<Netlist> run() {
    pugi::xml_document document;
    const auto parsed = document.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!parsed) {
      const auto at = static_cast<std::uint32_t>(std::min(std::ssize(text_), parsed.offset));
      errors_.report(Code::netlist_syntax, {index_, at, at}, std::string("no XML: ") + parsed.description());
      return std::nullopt;
    }
    const auto system = document.child("systemCatalog").child("systems").child("system");
    if (!system) {
      errors_.report(Code::netlist_syntax, {index_, 0, 0}, "expected systemCatalog/systems/system");
      return std::nullopt;
    }
    read(system);
    if (errors_.any()) return std::nullopt;
    return std::move(netlist_);
  }

 private:
  /// The name of an element: pugixml says where it begins.
  [[nodiscard]] Span span(pugi::xml_node element) const {
    const auto begin = static_cast<std::uint32_t>(element.offset_debug());
    return {index_, begin, begin + static_cast<std::uint32_t>(std::string_view(element.name()).size())};
  }

  void read(pugi::xml_node system) {
    netlist_.name = system.child_value("systemName");
    for (const auto& connection : system.child("connections").children("connection")) {
      const std::string from = connection.child_value("c1");
      const std::string to = connection.child_value("c2");
      if (from.empty() || to.empty()) {
        errors_.report(Code::netlist_syntax, span(connection),
                       std::string("a connection without ") + (from.empty() ? "c1" : "c2"));
      } else {
        join(pin(from), pin(to));
      }
    }
    for (const auto& component : system.child("components").children("component")) {
      const std::string name = component.child_value("name");
      const std::string_view type = component.child_value("componentType");
      const auto function = function_of(type);
      if (type != "port" && !function) continue;
      if (name.empty()) {
        errors_.report(Code::netlist_syntax, span(component), "a " + std::string(type) + " without a name");
      } else if (!names_.insert(name).second) {
        errors_.report(Code::netlist_driver, span(component), backquoted(name) + " is declared twice");
      } else if (type == "port") {
        ports_.push_back({name, span(component)});
      } else {
        gate(name, *function, span(component));
      }
    }
    if (netlist_.gates.empty()) errors_.report(Code::netlist_syntax, span(system), "a system without gates");
    finish();
  }

  std::size_t pin(const std::string& name) {
    const auto [at, fresh] = pins_.try_emplace(name, parent_.size());
    if (fresh) parent_.push_back(at->second);
    return at->second;
  }
  std::size_t root(std::size_t p) {
    while (parent_[p] != p) p = parent_[p] = parent_[parent_[p]];
    return p;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

  void gate(const std::string& name, GateFunction function, Span place) {
    Gate result{name, function, {}, pin(name + ".o")};
    for (std::size_t i = 1; pins_.contains(name + ".i" + std::to_string(i)); ++i) {
      result.inputs.push_back(pins_.at(name + ".i" + std::to_string(i)));
    }
    if (result.inputs.empty()) {
      errors_.report(Code::netlist_gate, place, "the gate " + backquoted(name) + " has no connected input");
    }
    netlist_.gates.push_back(std::move(result));
    gate_places_.push_back(place);
  }

  /// Pins become nets; a port is an output where a gate drives it, else an input.
  void finish() {
    std::map<std::size_t, Net> nets;
    const auto net = [&](std::size_t p) { return nets.try_emplace(root(p), nets.size()).first->second; };
    std::map<Net, Driver> driver;
    for (std::size_t g = 0; g < netlist_.gates.size(); ++g) {
      Gate& gate = netlist_.gates[g];
      for (Net& input : gate.inputs) input = net(input);
      gate.output = net(gate.output);
      const auto [first, fresh] = driver.try_emplace(gate.output, Driver{gate.name, gate_places_[g]});
      if (fresh) continue;
      const std::string both = backquoted(first->second.name) + " and " + backquoted(gate.name);
      if (auto* error = errors_.report(Code::netlist_driver, gate_places_[g], both + " drive one net")) {
        error->notes.push_back({first->second.place, "the other one is here"});
      }
    }
    for (const PlacedPort& port : ports_) {
      const Net on = net(pin(port.name));  // a port that nothing is connected to has a net of its own
      (driver.contains(on) ? netlist_.outputs : netlist_.inputs).push_back({port.name, on});
      driver.try_emplace(on, Driver{port.name, port.place});
    }
    netlist_.nets = nets.size();
    for (std::size_t g = 0; g < netlist_.gates.size(); ++g) {
      const auto& inputs = netlist_.gates[g].inputs;
      if (std::all_of(inputs.begin(), inputs.end(), [&](Net input) { return driver.contains(input); })) continue;
      errors_.report(Code::netlist_driver, gate_places_[g],
                     "nothing drives an input of " + backquoted(netlist_.gates[g].name));
    }
  }

  std::string_view text_;
  std::uint32_t index_;
  NetlistErrors errors_;
  Netlist netlist_;
  std::unordered_set<std::string> names_;  ///< of gates and ports
  std::vector<Span> gate_places_;
  std::vector<PlacedPort> ports_;
  std::unordered_map<std::string, std::size_t> pins_;
  std::vector<std::size_t> parent_;
};

}  // namespace

std::optional<Netlist> read_catalogue(const grammar::Sources& sources, std::uint32_t file,
                                      grammar::Diagnostics& diagnostics) {
  return CatalogueReader(sources[file], file, diagnostics).run();
}

}  // namespace rmpl::compiler
