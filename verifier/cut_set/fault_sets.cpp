// Sets of faults.
// SPDX-License-Identifier: MIT
#include "verifier/cut_set/fault_sets.hpp"

#include <algorithm>

#include "automata/fault_step.hpp"

namespace rmpl::verifier {

bool subset(const FaultSet& a, const FaultSet& b) {
  return std::includes(b.faults.begin(), b.faults.end(), a.faults.begin(), a.faults.end());
}

void FaultSetTree::add(const std::vector<Fault>& set) {
  std::uint32_t node = 0;
  for (const Fault& fault : set) {
    const auto [at, fresh] = nodes_[node].next.try_emplace(fault, static_cast<std::uint32_t>(nodes_.size()));
    node = at->second;
    if (fresh) nodes_.emplace_back();
  }
  nodes_[node].ends = true;
}

bool FaultSetTree::find(const std::vector<Fault>& set, bool proper) const {
  struct Place {
    std::uint32_t node;
    std::size_t from;   ///< faults of `set` before it are behind
    std::size_t taken;  ///< so many of them are on the way to the node
  };
  std::vector<Place> open = {{0, 0, 0}};
  while (!open.empty()) {
    const Place place = open.back();
    open.pop_back();
    const Node& node = nodes_[place.node];
    if (node.ends && !(proper && place.taken == set.size())) return true;
    if (node.next.empty()) continue;
    for (std::size_t f = place.from; f < set.size(); ++f) {
      const auto next = node.next.find(set[f]);
      if (next != node.next.end()) open.push_back({next->second, f + 1, place.taken + 1});
    }
  }
  return false;
}

TransitionSystem::FaultMeasures FaultSets::measures(unsigned number) const {
  const auto number_of = [](const Fault& fault) { return Units{fault.component.value} << 32 | fault.mode.value; };
  const FaultSet& set = *sets_[number];
  const Units first = set.faults.empty() ? unbounded : number_of(set.faults.front());
  const Units last = set.faults.empty() ? unbounded : -number_of(set.faults.back());
  return {-Units{set.count}, first, last};
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
    if (!automata::is_fault_step(plant.components[c], from[c], to[c])) continue;
    const Fault fault{automata::ComponentId(c), to[c]};
    const auto at = std::lower_bound(set.faults.begin(), set.faults.end(), fault);
    if (at == set.faults.end() || *at != fault) set.faults.insert(at, fault);
  }
  return number(std::move(set));
}

}  // namespace rmpl::verifier
