// System catalogues of the diagnostic competition: XML with components and connections between their pins.
//
// Everything that is not a gate only joins pins: wires, probes, ports, and the names that connections mention without
// declaring them. Joined pins are one net (union-find).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
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

constexpr std::array<std::pair<std::string_view, GateFunction>, 8> catalogue_functions{
    {{"and", GateFunction::conjunction},
     {"nand", GateFunction::negated_conjunction},
     {"or", GateFunction::disjunction},
     {"nor", GateFunction::negated_disjunction},
     {"xor", GateFunction::exclusive},
     {"xnor", GateFunction::negated_exclusive},
     {"inverter", GateFunction::negation},
     {"buffer", GateFunction::buffer}}};

/// What a component type says.
struct GateType {
  GateFunction function;
  std::size_t inputs;  ///< 0: two or more
};

/// What `nand2` and the like say; nothing for what is no gate.
std::optional<GateType> gate_type(std::string_view type) {
  for (const auto& [name, function] : catalogue_functions) {
    if (!type.starts_with(name)) continue;
    const bool unary = function == GateFunction::negation || function == GateFunction::buffer;
    GateType found{function, unary ? std::size_t{1} : 0};
    const std::string_view arity = type.substr(name.size());
    const auto [end, failure] = std::from_chars(arity.data(), arity.data() + arity.size(), found.inputs);
    if (arity.empty() || (failure == std::errc() && end == arity.data() + arity.size())) return found;
  }
  return std::nullopt;
}

/// Whether components of this type only join what is connected to them.
bool joins(std::string_view type) { return type.empty() || type == "wire" || type == "probe" || type == "port"; }

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
    if (!errors_.any()) report_loops(netlist_, gate_places_, errors_);
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
      const auto gate_kind = gate_type(type);
      if (type != "port" && joins(type)) continue;
      if (type != "port" && !gate_kind) {
        refuse(type, span(component));
      } else if (name.empty()) {
        errors_.report(Code::netlist_syntax, span(component), "a " + std::string(type) + " without a name");
      } else if (!names_.insert(name).second) {
        errors_.report(Code::netlist_driver, span(component), backquoted(name) + " is declared twice");
      } else if (type == "port") {
        ports_.push_back({name, span(component)});
      } else {
        gate(name, *gate_kind, span(component));
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

  /// A component of a kind that there is not.
  void refuse(std::string_view type, Span place) {
    refused_ = true;
    if (const auto reason = why_unsupported(type)) {
      errors_.report(Code::netlist_gate, place, *reason);
      return;
    }
    errors_.report(
        Code::netlist_gate, place,
        "unknown component type " + backquoted(type) +
            ", expected a gate (and2, nand3, or2, nor2, xor2, xnor2, inverter, buffer), wire, probe or port");
  }

  void gate(const std::string& name, const GateType& type, Span place) {
    Gate result{name, type.function, {}, pin(name + ".o")};
    for (std::size_t i = 1; pins_.contains(name + ".i" + std::to_string(i)); ++i) {
      result.inputs.push_back(pins_.at(name + ".i" + std::to_string(i)));
    }
    if (result.inputs.empty()) {
      errors_.report(Code::netlist_gate, place, "the gate " + backquoted(name) + " has no connected input");
    } else if (type.inputs == 0 ? result.inputs.size() < 2 : result.inputs.size() != type.inputs) {
      errors_.report(Code::netlist_gate, place,
                     "the gate " + backquoted(name) + " has " + std::to_string(result.inputs.size()) +
                         (result.inputs.size() == 1 ? " connected input" : " connected inputs") + ", expected " +
                         (type.inputs == 0 ? "two or more" : std::to_string(type.inputs)));
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
    if (refused_) return;  // it may be the driver that is missed
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
  bool refused_ = false;                   ///< some component
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
