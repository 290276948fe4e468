// Sets of faults.
// SPDX-License-Identifier: MIT
#include "verifier/plant/fault_sets.hpp"

#include <algorithm>

namespace rmpl::verifier {

bool subset(const FaultSet& a, const FaultSet& b) {
  return std::includes(b.faults.begin(), b.faults.end(), a.faults.begin(), a.faults.end());
}

unsigned FaultSets::number(FaultSet set) {
  const auto [at, fresh] = numbers_.try_emplace(std::move(set), static_cast<unsigned>(sets_.size()));
  if (fresh) sets_.push_back(&at->first);
  return at->second;
}

unsigned FaultSets::after(unsigned before, const automata::Plant& plant, const automata::Modes& from,
                          const automata::Modes& to, unsigned faults) {
  if (faults == 0) return before;
  FaultSet set = *sets_[before];
  set.count += faults;
  for (std::size_t c = 0; c < to.size(); ++c) {
    if (to[c] == from[c] || !plant.components[c].modes[to[c].index()].fault) continue;
    const Fault fault{automata::ComponentId(c), to[c]};
    const auto at = std::lower_bound(set.faults.begin(), set.faults.end(), fault);
    if (at == set.faults.end() || *at != fault) set.faults.insert(at, fault);
  }
  return number(std::move(set));
}

}  // namespace rmpl::verifier
