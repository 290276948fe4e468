// Recognising a circuit in a plant.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/circuit.hpp"

#include <algorithm>
#include <numeric>

namespace rmpl::runtime {
namespace {

using automata::Formula;
using automata::VariableId;

class Recogniser {
 public:
  explicit Recogniser(const automata::Plant& plant) : plant_(plant), parent_(plant.variables.size()) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::optional<Circuit> run() {
    for (const auto& [q, origin] : plant_.interconnections) {
      if (q.kind != Formula::Kind::equality) return std::nullopt;
      parent_[root(q.variable)] = root(q.other);
    }
    number_nets();
    circuit_.driver.resize(circuit_.nets);
    for (std::size_t c = 0; c < plant_.components.size(); ++c) {
      if (!add_gate(automata::ComponentId(c))) return std::nullopt;
    }
    if (!order()) return std::nullopt;
    return std::move(circuit_);
  }

 private:
  std::uint32_t root(VariableId id) {
    std::uint32_t v = id.value;
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  void number_nets() {
    std::vector<NetId> of_root(parent_.size(), Circuit::no_net);
    circuit_.net_of.assign(parent_.size(), Circuit::no_net);
    std::vector<bool> is_mode(parent_.size(), false);
    for (const auto& component : plant_.components) is_mode[component.mode.index()] = true;
    for (std::size_t v = 0; v < parent_.size(); ++v) {
      if (is_mode[v]) continue;
      NetId& net = of_root[root(VariableId(v))];
      if (net == Circuit::no_net) net = static_cast<NetId>(circuit_.nets++);
      circuit_.net_of[v] = net;
    }
  }

  /// The net of a two-valued attribute.
  std::optional<NetId> net(VariableId id) const {
    const NetId found = circuit_.net_of[id.index()];
    if (found == Circuit::no_net || plant_.variables[id].values.size() != 2) return std::nullopt;
    return found;
  }

  bool add_gate(automata::ComponentId id) {
    const auto& component = plant_[id];
    if (component.modes.size() != 2) return false;
    const std::size_t fault = component.modes[0].fault ? 0 : 1;
    if (!component.modes[fault].fault || component.modes[1 - fault].fault) return false;
    if (!component.modes[fault].constraint.is_true()) return false;
    CircuitGate gate{id, automata::ModeId(fault), 0, {}, {}};
    if (!read_behaviour(component.modes[1 - fault].constraint, gate)) return false;
    std::sort(gate.inputs.begin(), gate.inputs.end());
    gate.inputs.erase(std::unique(gate.inputs.begin(), gate.inputs.end()), gate.inputs.end());
    if (std::binary_search(gate.inputs.begin(), gate.inputs.end(), gate.output)) return false;
    if (circuit_.driver[gate.output]) return false;
    circuit_.driver[gate.output] = circuit_.gates.size();
    circuit_.gates.push_back(std::move(gate));
    return true;
  }

  bool read_behaviour(const Formula& behaviour, CircuitGate& gate) {
    if (behaviour.kind == Formula::Kind::equality) {
      const auto output = net(behaviour.variable);
      const auto input = net(behaviour.other);
      if (!output || !input) return false;
      gate.output = *output;
      gate.inputs = {*input};
      gate.function = {{GateStep::Kind::net, *input, false, 0}};
      return true;
    }
    if (behaviour.kind != Formula::Kind::equivalence) return false;
    const Formula& left = behaviour.operands[0];
    if (left.kind != Formula::Kind::member || left.values.size() != 1) return false;
    const auto output = net(left.variable);
    if (!output || !compile(behaviour.operands[1], gate)) return false;
    gate.output = *output;
    if (!Circuit::truth(left.values[0])) gate.function.push_back({GateStep::Kind::negation, 0, false, 1});
    return true;
  }

  bool compile(const Formula& formula, CircuitGate& gate) {
    const auto push = [&](GateStep::Kind kind, std::size_t count) { gate.function.push_back({kind, 0, false, count}); };
    switch (formula.kind) {
      case Formula::Kind::constant:
        gate.function.push_back({GateStep::Kind::constant, 0, formula.truth, 0});
        return true;
      case Formula::Kind::member: {
        const auto input = net(formula.variable);
        if (!input || formula.values.size() != 1) return false;
        gate.inputs.push_back(*input);
        gate.function.push_back({GateStep::Kind::net, *input, false, 0});
        if (!Circuit::truth(formula.values[0])) push(GateStep::Kind::negation, 1);
        return true;
      }
      case Formula::Kind::equality: {
        const auto left = net(formula.variable);
        const auto right = net(formula.other);
        if (!left || !right) return false;
        gate.inputs.insert(gate.inputs.end(), {*left, *right});
        gate.function.push_back({GateStep::Kind::net, *left, false, 0});
        gate.function.push_back({GateStep::Kind::net, *right, false, 0});
        push(GateStep::Kind::equivalence, 2);
        return true;
      }
      case Formula::Kind::clock:
      case Formula::Kind::knowledge:
        return false;
      case Formula::Kind::negation:
        if (!compile(formula.operands[0], gate)) return false;
        push(GateStep::Kind::negation, 1);
        return true;
      case Formula::Kind::conjunction:
      case Formula::Kind::disjunction:
      case Formula::Kind::equivalence:
        for (const Formula& operand : formula.operands) {
          if (!compile(operand, gate)) return false;
        }
        push(formula.kind == Formula::Kind::conjunction   ? GateStep::Kind::conjunction
             : formula.kind == Formula::Kind::disjunction ? GateStep::Kind::disjunction
                                                          : GateStep::Kind::equivalence,
             formula.operands.size());
        return true;
      case Formula::Kind::implication:
        if (!compile(formula.operands[0], gate)) return false;
        push(GateStep::Kind::negation, 1);
        if (!compile(formula.operands[1], gate)) return false;
        push(GateStep::Kind::disjunction, 2);
        return true;
    }
    return false;
  }

  /// Topological order, first declared first; false where there is a loop.
  bool order() {
    const std::size_t count = circuit_.gates.size();
    std::vector<std::size_t> waits(count, 0);
    std::vector<std::vector<std::size_t>> readers(circuit_.nets);
    std::vector<std::size_t> ready;
    for (std::size_t g = 0; g < count; ++g) {
      for (const NetId input : circuit_.gates[g].inputs) {
        readers[input].push_back(g);
        if (circuit_.driver[input]) ++waits[g];
      }
      if (waits[g] == 0) ready.push_back(g);
    }
    std::vector<CircuitGate> ordered;
    for (std::size_t next = 0; next < ready.size(); ++next) {
      CircuitGate& gate = circuit_.gates[ready[next]];
      for (const std::size_t reader : readers[gate.output]) {
        if (--waits[reader] == 0) ready.push_back(reader);
      }
      ordered.push_back(std::move(gate));
    }
    if (ordered.size() != count) return false;
    circuit_.gates = std::move(ordered);
    for (std::size_t g = 0; g < count; ++g) circuit_.driver[circuit_.gates[g].output] = g;
    return true;
  }

  const automata::Plant& plant_;
  std::vector<std::uint32_t> parent_;
  Circuit circuit_;
};

}  // namespace

std::optional<Circuit> circuit_of(const automata::Plant& plant) { return Recogniser(plant).run(); }

}  // namespace rmpl::runtime
