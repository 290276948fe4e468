// Parts, their top-level diagnoses by blocking clauses, and the product.
// SPDX-License-Identifier: MIT
#include "runtime/diagnose/enumerate.hpp"

#include <algorithm>

#include "runtime/diagnose/core_guided.hpp"

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

/// The witnesses of a group of gates by the solver, while those at `faulty` and no others are faulty.
std::vector<Expansion::Witness> witnesses(Encoding& encoding, const std::vector<std::size_t>& faulty,
                                          std::span<const std::size_t> group) {
  std::vector<Expansion::Witness> found;
  const Literal active = encoding.sat.fresh();
  std::vector<Literal> assumptions{active};
  std::vector<Literal> outputs(group.size());
  for (const std::size_t p : faulty) {
    assumptions.push_back(-encoding.healthy[p]);
    const auto at = std::find(group.begin(), group.end(), encoding.tops[p]);
    if (at != group.end()) outputs[static_cast<std::size_t>(at - group.begin())] = encoding.output(p);
  }
  while (encoding.sat.solve(assumptions)) {
    auto& witness = found.emplace_back();
    std::vector<Literal> different{-active};
    for (const Literal output : outputs) {
      witness.push_back(encoding.sat.value(output));
      different.push_back(witness.back() ? -output : output);
    }
    encoding.sat.add(different);
  }
  return found;
}

}  // namespace

Enumeration::Enumeration(const Subject& subject, bool list)
    : subject_(subject),
      list_(list),
      expansion_(subject.circuit, subject.sections, subject.known, subject.nominal, list) {}

cpp_int Enumeration::run(Encoding& encoding, const Report& report) {
  cpp_int count = 1;
  std::vector<std::vector<FaultSet>> sets;
  for (const Gates& part : expansion_.groups(possible_gates(encoding))) {
    count *= enumerate(part, sets.emplace_back());
  }
  if (!list_) return count;
  FaultSet faults;
  const auto combine = [&](const auto& self, std::size_t position) -> void {
    if (position == sets.size()) {
      FaultSet sorted = faults;
      std::sort(sorted.begin(), sorted.end());
      report(sorted);
      return;
    }
    for (const FaultSet& set : sets[position]) {
      faults.insert(faults.end(), set.begin(), set.end());
      self(self, position + 1);
      faults.resize(faults.size() - set.size());
    }
  };
  combine(combine, 0);
  return count;
}

cpp_int Enumeration::enumerate(const Gates& part, std::vector<FaultSet>& sets) {
  std::vector<bool> suspects(subject_.circuit.gates.size(), false);
  for (const std::size_t gate : part) suspects[gate] = true;
  Encoding encoding(subject_.circuit, subject_.sections, subject_.known, subject_.nominal, suspects);
  for (const NetId net : expansion_.observed(part)) encoding.include(net);
  CoreGuided guided(encoding.sat);
  for (const Literal healthy : encoding.healthy) guided.keep(healthy);
  guided.minimise();
  guided.commit();

  std::vector<std::size_t> faulty;
  const auto ask = [&](std::span<const std::size_t> group) { return witnesses(encoding, faulty, group); };
  const auto keep = [&](const FaultSet& faults) { sets.push_back(faults); };
  cpp_int count = 0;
  // Each top-level diagnosis comes after clauses that at least one gate of each found before works.
  while (encoding.sat.solve({})) {
    faulty = faulty_places(encoding);
    Gates tops;
    std::vector<Literal> blocking;
    for (const std::size_t p : faulty) {
      tops.push_back(encoding.tops[p]);
      blocking.push_back(encoding.healthy[p]);
    }
    count += expansion_.expand(tops, ask, keep);
    encoding.sat.add(blocking);
  }
  questions_ += encoding.sat.calls();
  return count;
}

}  // namespace runtime
