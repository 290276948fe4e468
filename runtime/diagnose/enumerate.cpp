// Parts, their top-level diagnoses by blocking clauses, and the product.
// SPDX-License-Identifier: MIT
#include "runtime/diagnose/enumerate.hpp"

#include <algorithm>
#include <map>

namespace runtime {

using automata::Literal;
using boost::multiprecision::cpp_int;

cpp_int Enumeration::run(const Report& report) {
  find_possible();
  cpp_int count = 1;
  std::vector<std::vector<FaultSet>> sets;
  for (const Places& part : parts()) {
    if (report) sets.emplace_back();
    count *= enumerate(part, report ? &sets.back() : nullptr);
  }
  if (!report) return count;
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

void Enumeration::take_model() {
  faulty_.clear();
  for (std::size_t p = 0; p < encoding_.tops.size(); ++p) {
    if (!encoding_.sat.value(encoding_.healthy[p])) faulty_.push_back(p);
  }
}

/// Asks for a model for each gate that was in none so far; one that is in none at all works from now on.
void Enumeration::find_possible() {
  possible_.assign(encoding_.tops.size(), false);
  const auto mark = [&] {
    take_model();
    for (const std::size_t p : faulty_) possible_[p] = true;
  };
  if (encoding_.sat.solve({})) mark();
  for (std::size_t p = 0; p < encoding_.tops.size(); ++p) {
    if (possible_[p]) continue;
    const Literal faulty = -encoding_.healthy[p];
    if (encoding_.sat.solve(std::span(&faulty, 1))) {
      mark();
    } else {
      encoding_.sat.add({encoding_.healthy[p]});
    }
  }
}

std::vector<Enumeration::Places> Enumeration::parts() const {
  std::map<std::size_t, std::size_t> place_of;
  std::vector<std::size_t> tops;
  for (std::size_t p = 0; p < encoding_.tops.size(); ++p) {
    if (!possible_[p]) continue;
    place_of.emplace(encoding_.tops[p], p);
    tops.push_back(encoding_.tops[p]);
  }
  std::vector<Places> all;
  for (const auto& group : expansion_.groups(tops)) {
    Places& part = all.emplace_back();
    for (const std::size_t top : group) part.push_back(place_of.at(top));
  }
  return all;
}

/// Each top-level diagnosis of a part comes after clauses that at least one gate of each found before works; they are
/// in force for this part only.
cpp_int Enumeration::enumerate(const Places& part, std::vector<FaultSet>* sets) {
  const Literal active = encoding_.sat.fresh();
  const auto keep = [&](const FaultSet& faults) { sets->push_back(faults); };
  const auto ask = [&](std::span<const std::size_t> group) { return witnesses(group); };
  cpp_int count = 0;
  while (encoding_.sat.solve(std::span(&active, 1))) {
    take_model();
    std::vector<std::size_t> tops;
    std::vector<Literal> blocking{-active};
    for (const std::size_t p : part) {
      if (encoding_.sat.value(encoding_.healthy[p])) continue;
      tops.push_back(encoding_.tops[p]);
      blocking.push_back(encoding_.healthy[p]);
    }
    count += expansion_.expand(tops, ask, keep);
    encoding_.sat.add(blocking);
  }
  return count;
}

/// Of a group of faulty gates, by the solver, in what the other gates of the last model leave open.
std::vector<Expansion::Witness> Enumeration::witnesses(std::span<const std::size_t> group) {
  std::vector<Expansion::Witness> found;
  const Literal active = encoding_.sat.fresh();
  std::vector<Literal> assumptions{active};
  std::vector<Literal> outputs(group.size());
  for (const std::size_t p : faulty_) {
    assumptions.push_back(-encoding_.healthy[p]);
    const auto at = std::find(group.begin(), group.end(), encoding_.tops[p]);
    if (at != group.end()) outputs[static_cast<std::size_t>(at - group.begin())] = encoding_.output(p);
  }
  while (encoding_.sat.solve(assumptions)) {
    auto& witness = found.emplace_back();
    std::vector<Literal> different{-active};
    for (const Literal output : outputs) {
      witness.push_back(encoding_.sat.value(output));
      different.push_back(witness.back() ? -output : output);
    }
    encoding_.sat.add(different);
  }
  return found;
}

}  // namespace runtime
