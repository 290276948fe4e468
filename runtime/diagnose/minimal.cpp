// Minimum-cardinality diagnosis of a circuit: encode, minimise, enumerate top-level diagnoses, expand.
// SPDX-License-Identifier: MIT
#include "runtime/diagnose/minimal.hpp"

#include <algorithm>
#include <cassert>

#include "automata/logic/sat.hpp"
#include "runtime/diagnose/core_guided.hpp"
#include "runtime/diagnose/expand.hpp"

namespace runtime {
namespace {

using automata::Literal;
using automata::Sat;

/// The circuit under one observation in clauses. Constants are folded, so what the inputs decide costs nothing; a
/// dominated gate works and needs no variable of its own beyond its function.
class Encoding {
 public:
  Encoding(const Circuit& circuit, const Sections& sections, const Known& known) : true_(sat.fresh()) {
    sat.add({true_});
    nets.assign(circuit.nets, true_);
    for (std::size_t n = 0; n < circuit.nets; ++n) {
      if (known[n]) nets[n] = *known[n] ? true_ : -true_;
    }
    for (std::size_t g = 0; g < circuit.gates.size(); ++g) {
      if (!sections.top[g]) continue;
      const CircuitGate& gate = circuit.gates[g];
      const Literal value = function(gate);
      if (*sections.top[g] != g) {
        nets[gate.output] = value;
        continue;
      }
      if (!known[gate.output]) nets[gate.output] = sat.fresh();
      const Literal output = nets[gate.output];
      if (output == value) continue;
      const Literal works = sat.fresh();
      clause({-works, -output, value});
      clause({-works, output, -value});
      tops.push_back(g);
      healthy.push_back(works);
    }
  }

  Sat sat;
  std::vector<Literal> nets;
  std::vector<std::size_t> tops;  ///< undominated gates that can matter, and beside them:
  std::vector<Literal> healthy;   ///< "this gate works"

 private:
  void clause(std::vector<Literal> literals) {
    if (std::find(literals.begin(), literals.end(), true_) != literals.end()) return;
    std::erase(literals, -true_);
    sat.add(literals);
  }

  Literal conjunction(std::vector<Literal> inputs) {
    std::sort(inputs.begin(), inputs.end());
    inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
    std::erase(inputs, true_);
    for (const Literal input : inputs) {
      if (input == -true_ || std::binary_search(inputs.begin(), inputs.end(), -input)) return -true_;
    }
    if (inputs.empty()) return true_;
    if (inputs.size() == 1) return inputs[0];
    const Literal gate = sat.fresh();
    std::vector<Literal> closing{gate};
    for (const Literal input : inputs) {
      sat.add({-gate, input});
      closing.push_back(-input);
    }
    sat.add(closing);
    return gate;
  }

  Literal equivalence(Literal a, Literal b) {
    if (a == true_ || b == true_) return a == true_ ? b : a;
    if (a == -true_ || b == -true_) return a == -true_ ? -b : -a;
    if (a == b || a == -b) return a == b ? true_ : -true_;
    const Literal gate = sat.fresh();
    sat.add({-gate, -a, b});
    sat.add({-gate, a, -b});
    sat.add({gate, a, b});
    sat.add({gate, -a, -b});
    return gate;
  }

  Literal function(const CircuitGate& gate) {
    std::vector<Literal> stack;
    for (const GateStep& step : gate.function) {
      const auto from = stack.end() - static_cast<std::ptrdiff_t>(step.count);
      switch (step.kind) {
        case GateStep::Kind::net:
          stack.push_back(nets[step.net]);
          break;
        case GateStep::Kind::constant:
          stack.push_back(step.truth ? true_ : -true_);
          break;
        case GateStep::Kind::negation:
          stack.back() = -stack.back();
          break;
        case GateStep::Kind::conjunction:
        case GateStep::Kind::disjunction: {
          // A disjunction is the negation of the conjunction of the negations.
          const int sign = step.kind == GateStep::Kind::conjunction ? 1 : -1;
          std::vector<Literal> inputs(from, stack.end());
          for (Literal& input : inputs) input *= sign;
          stack.erase(from, stack.end());
          stack.push_back(sign * conjunction(std::move(inputs)));
          break;
        }
        case GateStep::Kind::equivalence: {
          Literal value = *from;
          for (auto at = from + 1; at != stack.end(); ++at) value = equivalence(value, *at);
          stack.erase(from, stack.end());
          stack.push_back(value);
          break;
        }
      }
    }
    return stack.back();
  }

  Literal true_;
};

/// Witnesses of one top-level diagnosis by the solver: for diagnoses too large to simulate every vector.
std::vector<std::vector<bool>> witnesses_by_solver(Encoding& encoding, const Circuit& circuit,
                                                   const std::vector<std::size_t>& positions) {
  std::vector<std::vector<bool>> found;
  const Literal active = encoding.sat.fresh();
  std::vector<Literal> assumptions{active};
  for (const std::size_t p : positions) assumptions.push_back(-encoding.healthy[p]);
  while (encoding.sat.solve(assumptions)) {
    auto& witness = found.emplace_back();
    std::vector<Literal> different{-active};
    for (const std::size_t p : positions) {
      const Literal output = encoding.nets[circuit.gates[encoding.tops[p]].output];
      witness.push_back(encoding.sat.value(output));
      different.push_back(witness.back() ? -output : output);
    }
    encoding.sat.add(different);
  }
  return found;
}

}  // namespace

void CircuitDiagnosis::prepare(const std::vector<bool>& observed) {
  if (observed == observed_) return;
  observed_ = observed;
  sections_ = sections_of(circuit_, observed);
}

std::optional<MinimalDiagnoses> CircuitDiagnosis::solve(std::span<const automata::Assignment> observation, Scope scope,
                                                        const std::function<void(const FaultSet&)>& report) {
  Known known(circuit_.nets);
  for (const automata::Assignment& reading : observation) {
    const NetId net = circuit_.net_of[reading.variable.index()];
    if (net == Circuit::no_net) return std::nullopt;
    const bool value = Circuit::truth(reading.value);
    if (known[net].value_or(value) != value) return std::nullopt;
    known[net] = value;
  }
  std::vector<bool> observed(circuit_.nets);
  for (std::size_t n = 0; n < circuit_.nets; ++n) {
    observed[n] = known[n].has_value();
    if (!circuit_.driver[n] && !known[n]) return std::nullopt;
  }
  prepare(observed);

  Encoding encoding(circuit_, sections_, known);
  CoreGuided guided(encoding.sat, encoding.healthy);
  if (!guided.minimise()) return std::nullopt;
  MinimalDiagnoses result{guided.cost(), 0, 0};
  if (scope != Scope::first) guided.commit();
  Expansion expansion(circuit_, sections_, known);
  // The model that ended the minimisation is the first diagnosis; each further one comes after a clause that at least
  // one gate of each found before works.
  while (true) {
    std::vector<std::size_t> tops, positions;
    std::vector<Literal> blocking;
    if (scope != Scope::first && !encoding.sat.solve({})) break;
    for (std::size_t p = 0; p < encoding.tops.size(); ++p) {
      if (encoding.sat.value(encoding.healthy[p])) continue;
      positions.push_back(p);
      tops.push_back(encoding.tops[p]);
      blocking.push_back(encoding.healthy[p]);
    }
    assert(tops.size() == guided.cost() && "a model at the bound breaks as many soft literals as it costs");
    if (scope == Scope::first) {
      FaultSet faults;
      for (const std::size_t g : tops) faults.push_back(circuit_.gates[g].component);
      std::sort(faults.begin(), faults.end());
      result.count = 1;
      report(faults);
      break;
    }
    const auto witnesses = tops.size() <= Expansion::exhaustive_limit
                               ? expansion.witnesses(tops)
                               : witnesses_by_solver(encoding, circuit_, positions);
    result.count += expansion.expand(tops, witnesses, scope == Scope::list ? report : nullptr);
    if (blocking.empty()) break;
    encoding.sat.add(blocking);
  }
  result.checked = encoding.sat.calls();
  return result;
}

}  // namespace runtime
