// A plant seen as a combinational circuit: what makes snapshot diagnosis of thousands of gates quick.
//
// Many plants of the diagnosis literature are circuits with a weak fault model: every component drives one two-valued
// output as a function of its inputs while it works, and anything once it is faulty. For them much more can be said
// than for plants at large: with the inputs known and the outputs of the faulty gates fixed, every net has one value.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "automata/plant.hpp"

namespace rmpl::runtime {

/// A set of joined variables of a circuit.
using NetId = std::uint32_t;

/// One step of a gate's function in postfix order, over a stack of values.
struct GateStep {
  enum class Kind { net, constant, negation, conjunction, disjunction, equivalence } kind;
  NetId net = 0;          ///< of `net`
  bool truth = false;     ///< of `constant`
  std::size_t count = 1;  ///< operands taken from the stack: two or more for the last three kinds
};

struct CircuitGate {
  automata::ComponentId component;
  automata::ModeId fault;  ///< its one fault mode
  NetId output;
  std::vector<NetId> inputs;       ///< each once
  std::vector<GateStep> function;  ///< of the output, while the gate works
};

/// Gates in an order in which each comes after those that drive its inputs.
struct Circuit {
  std::size_t nets = 0;
  std::vector<CircuitGate> gates;
  std::vector<std::optional<std::size_t>> driver;  ///< per net: the gate that drives it
  std::vector<NetId> net_of;                       ///< per variable; `no_net` for mode variables
  static constexpr NetId no_net = ~NetId{0};
  /// Of a two-valued attribute: which value counts as true is the second of its domain.
  static bool truth(automata::ValueId value) { return value.index() == 1; }
};

/// The plant as a circuit, or nothing where it is none: each component has one nominal mode, with a constraint
/// `output <-> f(inputs)` or `output = input` over two-valued attributes, and one unconstrained fault mode; the
/// interconnections are equalities; no net is driven twice; there is no loop.
std::optional<Circuit> circuit_of(const automata::Plant& plant);

}  // namespace rmpl::runtime
