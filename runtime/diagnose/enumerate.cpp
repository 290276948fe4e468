// Parts, their top-level diagnoses by blocking clauses, and the product.
// SPDX-License-Identifier: MIT
#include "runtime/diagnose/enumerate.hpp"

#include <algorithm>

#include "runtime/diagnose/core_guided.hpp"
#include "runtime/diagnose/expand.hpp"

namespace runtime {
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

/// The gates that are faulty in some model. Each that was in none so far is asked for; one that is in none at all is
/// told to work, which makes the next question easier.
std::vector<std::size_t> possible_gates(Encoding& encoding) {
  std::vector<bool> possible(encoding.tops.size(), false);
  const auto mark = [&] {
    for (const std::size_t p : faulty_places(encoding)) possible[p] = true;
  };
  if (encoding.sat.solve({})) mark();
  std::vector<std::size_t> gates;
  for (std::size_t p = 0; p < encoding.tops.size(); ++p) {
    const Literal faulty = -encoding.healthy[p];
    if (!possible[p] && encoding.sat.solve(std::span(&faulty, 1))) mark();
    if (possible[p]) {
      gates.push_back(encoding.tops[p]);
    } else {
      encoding.sat.add({encoding.healthy[p]});
    }
  }
  return gates;
}

/// Calls `report` with each way to take one member of each list, joined to `taken`.
template <class List, class Report>
void product(const std::vector<List>& lists, std::size_t position, FaultSet& taken, const Report& report) {
  if (position == lists.size()) {
    report(taken);
    return;
  }
  const std::size_t before = taken.size();
  for (const FaultSet& member : lists[position]) {
    taken.insert(taken.end(), member.begin(), member.end());
    product(lists, position + 1, taken, report);
    taken.resize(before);
  }
}

}  // namespace

cpp_int Enumeration::run(Encoding& encoding, const Report& report) {
  cpp_int count = 1;
  std::vector<std::vector<FaultSet>> sets;
  for (const Gates& part : reach_.groups(possible_gates(encoding))) {
    count *= enumerate(part, sets.emplace_back());
  }
  if (!list_) return count;
  FaultSet faults;
  product(sets, 0, faults, [&](const FaultSet& taken) {
    FaultSet sorted = taken;
    std::sort(sorted.begin(), sorted.end());
    report(sorted);
  });
  return count;
}

cpp_int Enumeration::enumerate(const Gates& part, std::vector<FaultSet>& sets) {
  std::vector<bool> suspects(subject_.circuit.gates.size(), false);
  for (const std::size_t gate : part) suspects[gate] = true;
  Encoding encoding(subject_.circuit, subject_.sections, subject_.known, subject_.nominal, suspects);
  for (const NetId net : reach_.observed(part)) encoding.include(net);
  CoreGuided guided(encoding.sat);
  for (const Literal healthy : encoding.healthy) guided.keep(healthy);
  guided.minimise();
  guided.commit();

  Expansion expansion(subject_.circuit, subject_.sections, subject_.known, subject_.nominal, reach_.cone(part));
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
    for (const std::size_t gate : choice) single.push_back({subject_.circuit.gates[gate].component});
  }
  FaultSet faults;
  product(components, 0, faults, [&](const FaultSet& taken) { sets.push_back(taken); });
}

}  // namespace runtime
