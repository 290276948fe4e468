// The simulation of a circuit whose observed nets are cut.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/simulate.hpp"

namespace rmpl::runtime {

CutSimulation::CutSimulation(const Circuit& circuit, const Known& known)
    : circuit_(circuit), known_(known), values_(circuit.nets, 0) {
  for (std::size_t n = 0; n < circuit.nets; ++n) values_[n] = known[n].value_or(false) ? ~Word{0} : 0;
}

const std::vector<NetId>& CutSimulation::unexplained(std::span<const Forced> forced) {
  unexplained_.clear();
  for (std::size_t g = 0; g < circuit_.gates.size(); ++g) {
    const CircuitGate& gate = circuit_.gates[g];
    Word value = 0;
    if (!forced.empty() && forced.front().gate == g) {
      value = forced.front().value ? ~Word{0} : 0;
      forced = forced.subspan(1);
    } else {
      value = evaluate_(gate, [&](NetId net) { return values_[net]; });
    }
    if (!known_[gate.output]) {
      values_[gate.output] = value;
    } else if (value != values_[gate.output]) {
      unexplained_.push_back(gate.output);
    }
  }
  return unexplained_;
}

}  // namespace rmpl::runtime
