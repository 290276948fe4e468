// A netlist as a plant: one component type a kind of gate, one instance a gate, one equality a connection.
// SPDX-License-Identifier: MIT
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include "compiler/import/netlist.hpp"

namespace rmpl::compiler {
namespace {

std::string type_name(GateFunction function, std::size_t inputs) {
  const std::string arity = std::to_string(inputs);
  switch (function) {
    case GateFunction::conjunction:
      return "And" + arity;
    case GateFunction::negated_conjunction:
      return "Nand" + arity;
    case GateFunction::disjunction:
      return "Or" + arity;
    case GateFunction::negated_disjunction:
      return "Nor" + arity;
    case GateFunction::exclusive:
      return "Xor" + arity;
    case GateFunction::negated_exclusive:
      return "Xnor" + arity;
    case GateFunction::negation:
      return "Inverter";
    case GateFunction::buffer:
      return "Buffer";
  }
  return {};
}

/// That an odd number of the inputs from `first` to `last` is true: halves of halves, as deep as the logarithm.
std::string parity(std::size_t first, std::size_t last) {
  if (first == last) return "i" + std::to_string(first) + " = true";
  const std::size_t middle = first + (last - first) / 2;
  return "!(" + parity(first, middle) + " <-> " + parity(middle + 1, last) + ")";
}

std::string joined(std::size_t inputs, const std::string& separator) {
  std::string text;
  for (std::size_t i = 1; i <= inputs; ++i) text += (i == 1 ? "" : separator) + "i" + std::to_string(i) + " = true";
  return text;
}

/// What a working gate of this kind keeps true of its output `o` and inputs `i1` ….
std::string behaviour(GateFunction function, std::size_t inputs) {
  switch (function) {
    case GateFunction::conjunction:
      return "o = true <-> " + joined(inputs, " & ");
    case GateFunction::negated_conjunction:
      return "o = true <-> !(" + joined(inputs, " & ") + ")";
    case GateFunction::disjunction:
      return "o = true <-> " + joined(inputs, " | ");
    case GateFunction::negated_disjunction:
      return "o = true <-> !(" + joined(inputs, " | ") + ")";
    case GateFunction::exclusive:
      return "o = true <-> " + parity(1, inputs);
    case GateFunction::negated_exclusive:
      return "o = true <-> !(" + parity(1, inputs) + ")";
    case GateFunction::negation:
      return "o = true <-> i1 = false";
    case GateFunction::buffer:
      return "o = i1";
  }
  return {};
}

std::string component(GateFunction function, std::size_t inputs, FaultModel faults) {
  std::string text = "component " + type_name(function, inputs) + " {\n  input    ";
  for (std::size_t i = 1; i <= inputs; ++i) text += (i == 1 ? "i" : ", i") + std::to_string(i);
  text += " : Bit;\n  output   o : Bit;\n  initial  ok;\n  mode     ok { " + behaviour(function, inputs) + " };\n";
  switch (faults) {
    case FaultModel::weak:
      return text + "  fault    faulty;\n  ok -> faulty with 0.01;\n}\n\n";
    case FaultModel::strong:
      return text +
             "  fault    stuck-at-0 { o = false };\n  fault    stuck-at-1 { o = true };\n  fault    unknown;\n"
             "  ok -> stuck-at-0 with 0.099;\n  ok -> stuck-at-1 with 0.099;\n  ok -> unknown with 0.002;\n}\n\n";
  }
  return text;
}

/// A text that stands in a comment: of one line.
std::string in_one_line(std::string text) {
  for (char& c : text) {
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = ' ';
  }
  return text;
}

std::string ports(const char* direction, const std::vector<Port>& all) {
  std::string text;
  for (const Port& port : all) text += std::string("  ") + direction + port.name + " : Bit;\n";
  return text;
}

}  // namespace

std::string to_tcca(const Netlist& given, FaultModel faults) {
  const Netlist netlist = with_identifiers(given);
  std::set<std::pair<GateFunction, std::size_t>> kinds;
  for (const Gate& gate : netlist.gates) kinds.emplace(gate.function, gate.inputs.size());
  std::set<std::string> gate_names;
  for (const Gate& gate : netlist.gates) gate_names.insert(gate.name);
  std::set<std::string> input_names;
  for (const Port& port : netlist.inputs) input_names.insert(port.name);
  // An output port that has its gate's name (in .bench files all have) is that gate's pin; one that has an input's, and
  // so is on its net, is that input, which is observed anyway.
  std::vector<Port> outputs;
  std::vector<std::string> observed;
  for (const Port& port : netlist.inputs) observed.push_back(port.name);
  for (const Port& port : netlist.outputs) {
    if (input_names.contains(port.name)) continue;
    const bool pin = gate_names.contains(port.name);
    if (!pin) outputs.push_back(port);
    observed.push_back(pin ? port.name + ".o" : port.name);
  }

  std::string text = "// " + in_one_line(netlist.name) + ": " + std::to_string(netlist.gates.size()) + " gates, " +
                     std::to_string(netlist.inputs.size()) + " inputs, " + std::to_string(netlist.outputs.size()) +
                     " outputs.\n\ndomain Bit = { false, true };\n\n";
  for (const auto& [function, inputs] : kinds) text += component(function, inputs, faults);

  std::map<Net, std::string> driver;
  for (const Port& port : netlist.inputs) driver.emplace(port.net, port.name);
  for (const Gate& gate : netlist.gates) driver.emplace(gate.output, gate.name + ".o");

  text += "plant Circuit {\n" + ports("input    ", netlist.inputs) + ports("output   ", outputs);
  for (const Gate& gate : netlist.gates) {
    text += "  " + gate.name + " : " + type_name(gate.function, gate.inputs.size()) + ";\n";
  }
  for (const Gate& gate : netlist.gates) {
    for (std::size_t i = 0; i < gate.inputs.size(); ++i) {
      text += "  " + gate.name + ".i" + std::to_string(i + 1) + " = " + driver.at(gate.inputs[i]) + ";\n";
    }
  }
  for (const Port& port : outputs) text += "  " + port.name + " = " + driver.at(port.net) + ";\n";
  for (const std::string& name : observed) text += "  observe " + name + ";\n";
  return text + "}\n";
}

}  // namespace rmpl::compiler
