// Minimum-cardinality diagnosis of a circuit: encode, minimise, enumerate top-level diagnoses, expand.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/minimal.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "runtime/reasoning/diagnose/core_guided.hpp"
#include "runtime/reasoning/diagnose/encoding.hpp"

namespace rmpl::runtime {

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

  CutSimulation simulation(circuit_, known);
  std::vector<NetId> demands = simulation.unexplained({});
  const std::vector<Word> nominal = simulation.values();
  const std::vector<bool> all_gates;
  Encoding encoding(circuit_, sections_, known, nominal, all_gates);
  CoreGuided guided(encoding.sat);
  std::vector<Forced> forced;
  const auto take_model = [&] {
    forced.clear();
    for (std::size_t p = 0; p < encoding.tops.size(); ++p) {
      if (encoding.sat.value(encoding.healthy[p])) continue;
      forced.push_back({encoding.tops[p], encoding.sat.value(encoding.output(p))});
    }
    std::sort(forced.begin(), forced.end(), [](const Forced& a, const Forced& b) { return a.gate < b.gate; });
  };
  // Only the cones of nets that are not as they should be are encoded; those of further nets when a diagnosis of what
  // is there fails to explain them.
  for (std::size_t included = 0; !demands.empty(); demands = simulation.unexplained(forced)) {
    for (const NetId net : demands) encoding.include(net);
    for (; included < encoding.healthy.size(); ++included) guided.keep(encoding.healthy[included]);
    [[maybe_unused]] const bool explained = guided.minimise();
    CHECK(explained && "the gates that drive them explain all observed nets");
    take_model();
    CHECK(forced.size() == guided.cost() && "a model at the bound breaks as many soft literals as it costs");
  }

  MinimalDiagnoses result{guided.cost(), 1, encoding.sat.calls()};
  if (scope == Scope::first) {
    FaultSet faults;
    for (const Forced& gate : forced) faults.push_back(circuit_.gates[gate.gate].component);
    std::sort(faults.begin(), faults.end());
    report(faults);
    return result;
  }
  // A diagnosis with a gate outside the cones would have one fault fewer inside them than is possible.
  encoding.no_more_faults();
  for (std::size_t n = 0; n < circuit_.nets; ++n) {
    if (known[n] && circuit_.driver[n]) encoding.include(static_cast<NetId>(n));
  }
  guided.commit();
  Enumeration enumeration(circuit_, sections_, known, scope == Scope::list);
  result.count = enumeration.run(encoding, report);
  result.checked = encoding.sat.calls() + enumeration.questions();
  return result;
}

}  // namespace rmpl::runtime
