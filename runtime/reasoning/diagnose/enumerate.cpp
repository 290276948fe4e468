// Parts, their top-level diagnoses by blocking clauses, and the product.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/diagnose/enumerate.hpp"

#include <algorithm>

#include "base/product.hpp"
#include "runtime/reasoning/diagnose/core_guided.hpp"
#include "runtime/reasoning/diagnose/expand.hpp"

namespace rmpl::runtime {
namespace {

using automata::Literal;
using boost::multiprecision::cpp_int;

/// The places of the gates that are faulty in the solver's model.
std::vector<std::size_t> faulty_places(const Encoding& encoding) {
  std::vector<std::size_t> places;
  for (std::size_t p = 0; p < encoding.tops.size(); ++p) {
    if (!encoding.sat.value(encoding.healthy[p])) places.push_back(p);
  }
  return places;
}

/// Calls `report` with each way to take one member of each list, joined to `taken`.
template <class List, class Report>
void product(const std::vector<List>& lists, FaultSet& taken, const Report& report) {
  base::multiply_out(
      lists,
      [&](std::size_t list, std::size_t i) {
        taken.insert(taken.end(), lists[list][i].begin(), lists[list][i].end());
        return true;
      },
      [&](std::size_t list, std::size_t i) { taken.resize(taken.size() - lists[list][i].size()); },
      [&] {
        report(taken);
        return false;
      });
}

}  // namespace

/// What has not been seen in any model so far is asked for; what is in none is told to the solver, which makes the next
/// question easier.
Enumeration::Gates Enumeration::possible_gates(Encoding& encoding) {
  const std::size_t count = encoding.tops.size();
  std::vector<bool> faulty(count, false);
  std::vector<bool> high(count, false);
  std::vector<bool> low(count, false);
  const auto seen = [&](Literal literal) {
    if (!encoding.sat.solve(std::span(&literal, literal != 0 ? 1 : 0))) return false;
    for (std::size_t p = 0; p < count; ++p) {
      if (!encoding.sat.value(encoding.healthy[p])) faulty[p] = true;
      (encoding.sat.value(encoding.output(p)) ? high : low)[p] = true;
    }
    return true;
  };
  seen(0);
  Gates gates;
  for (std::size_t p = 0; p < count; ++p) {
    if (!faulty[p] && !seen(-encoding.healthy[p])) encoding.sat.add({encoding.healthy[p]});
    if (faulty[p]) gates.push_back(encoding.tops[p]);
  }
  for (std::size_t p = 0; p < count; ++p) {
    if (high[p] && low[p]) continue;
    const Literal other = high[p] ? -encoding.output(p) : encoding.output(p);
    if (seen(other)) continue;
    encoding.sat.add({-other});
    known_[circuit_.gates[encoding.tops[p]].output] = high[p];
  }
  return gates;
}

cpp_int Enumeration::run(Encoding& encoding, const Report& report) {
  const Gates possible = possible_gates(encoding);
  CutSimulation simulation(circuit_, known_);
  simulation.unexplained({});
  const Reach reach(circuit_, known_);
  cpp_int count = 1;
  std::vector<std::vector<FaultSet>> sets;
  for (const Gates& part : reach.groups(possible)) {
    count *= enumerate(reach, simulation.values(), part, sets.emplace_back());
  }
  if (!list_) return count;
  FaultSet faults;
  product(sets, faults, [&](const FaultSet& taken) {
    FaultSet sorted = taken;
    std::sort(sorted.begin(), sorted.end());
    report(sorted);
  });
  return count;
}

cpp_int Enumeration::enumerate(const Reach& reach, const std::vector<Word>& nominal, const Gates& part,
                               std::vector<FaultSet>& sets) {
  std::vector<bool> suspects(circuit_.gates.size(), false);
  for (const std::size_t gate : part) suspects[gate] = true;
  Encoding encoding(circuit_, sections_, known_, nominal, suspects);
  for (const NetId net : reach.observed(part)) encoding.include(net);
  CoreGuided guided(encoding.sat);
  for (const Literal healthy : encoding.healthy) guided.keep(healthy);
  guided.minimise();
  guided.commit();

  Expansion expansion(circuit_, sections_, known_, nominal, reach.cone(part));
  cpp_int count = 0;
  // Each top-level diagnosis comes after clauses that at least one gate of each found before works.
  while (encoding.sat.solve({})) {
    Gates tops;
    std::vector<Literal> blocking;
    for (const std::size_t p : faulty_places(encoding)) {
      tops.push_back(encoding.tops[p]);
      blocking.push_back(encoding.healthy[p]);
    }
    std::sort(tops.begin(), tops.end());
    const auto& choices = expansion.choices(tops);
    cpp_int combinations = 1;
    for (const Gates& choice : choices) combinations *= choice.size();
    count += combinations;
    if (list_) keep(choices, sets);
    encoding.sat.add(blocking);
  }
  questions_ += encoding.sat.calls();
  return count;
}

void Enumeration::keep(const std::vector<Gates>& choices, std::vector<FaultSet>& sets) const {
  std::vector<std::vector<FaultSet>> components;
  for (const Gates& choice : choices) {
    auto& single = components.emplace_back();
    for (const std::size_t gate : choice) single.push_back({circuit_.gates[gate].component});
  }
  FaultSet faults;
  product(components, faults, [&](const FaultSet& taken) { sets.push_back(taken); });
}

}  // namespace rmpl::runtime
