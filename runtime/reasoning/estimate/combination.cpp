// Combinations from beliefs, and back.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/combination.hpp"

#include <algorithm>
#include <map>

#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/order.hpp"

namespace rmpl::runtime {

void put_in_order(Combinations& combinations) {
  for (Combination& combination : combinations) {
    if (combination.clocks.size() < 2) continue;
    put_in_order(combination.clocks, [](const Clocked& a, const Clocked& b) { return a.starts < b.starts; });
  }
  put_in_order(combinations, [](const Combination& a, const Combination& b) {
    return a.modes != b.modes ? a.modes < b.modes : a.clocks.front().starts < b.clocks.front().starts;
  });
}

Belief states_of(const Combinations& combinations) {
  Belief belief;
  bool one_each = true;
  for (const Combination& combination : combinations) {
    one_each = one_each && combination.clocks.size() == 1;
    for (const Clocked& clocked : combination.clocks) {
      belief.push_back({{combination.modes, clocked.starts}, clocked.probability});
    }
  }
  if (!one_each) put_in_order(belief);
  return belief;
}

Combinations combinations_of(const Belief& belief) {
  Combinations result;
  std::map<automata::Modes, std::size_t> places;
  for (const BeliefEntry& entry : belief) {
    const auto [known, fresh] = places.try_emplace(entry.state.modes, result.size());
    if (fresh) result.push_back({entry.state.modes, 0, {}});
    Combination& combination = result[known->second];
    combination.probability += entry.probability;
    combination.clocks.push_back({entry.state.clock_starts, entry.probability});
  }
  put_in_order(result);
  return result;
}

void find_differing(const Combination& combination, const Clocks& clocks, std::vector<std::size_t>& result) {
  result.clear();
  const std::vector<Clocked>& all = combination.clocks;
  if (all.size() == 1) return;
  clocks.kept(combination.modes, result);
  std::erase_if(result, [&](std::size_t c) {
    return std::all_of(all.begin() + 1, all.end(),
                       [&](const Clocked& clocked) { return clocked.starts[c] == all.front().starts[c]; });
  });
}

double total(const Combinations& combinations) {
  double sum = 0;
  for (const Combination& combination : combinations) sum += combination.probability;
  return sum;
}

void scale(Combinations& combinations, double factor) {
  for (Combination& combination : combinations) {
    combination.probability *= factor;
    for (Clocked& clocked : combination.clocks) clocked.probability *= factor;
  }
}

void normalise(Combinations& combinations) {
  const double sum = total(combinations);
  if (!(sum > 0)) return;
  for (Combination& combination : combinations) {
    combination.probability /= sum;
    for (Clocked& clocked : combination.clocks) clocked.probability /= sum;
  }
}

}  // namespace rmpl::runtime
