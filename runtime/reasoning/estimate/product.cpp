// Products of beliefs, best first: an optimal constraint satisfaction problem without constraints.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/product.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>

#include "runtime/reasoning/estimate/belief.hpp"
#include "runtime/reasoning/estimate/combination.hpp"
#include "runtime/reasoning/estimate/order.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {
namespace {

/// The state that takes the given entry of each factor.
BeliefEntry combine(std::span<const Factor> factors, std::span<const std::uint32_t> entries, std::size_t components) {
  BeliefEntry result;
  result.state.modes.resize(components);
  result.state.clock_starts.resize(components);
  result.probability = 1;
  for (std::size_t f = 0; f < factors.size(); ++f) {
    const BeliefEntry& entry = (*factors[f].belief)[entries[f]];
    result.probability *= entry.probability;
    for (std::size_t i = 0; i < factors[f].components.size(); ++i) {
      const std::size_t c = factors[f].components[i].index();
      result.state.modes[c] = entry.state.modes[i];
      result.state.clock_starts[c] = entry.state.clock_starts[i];
    }
  }
  return result;
}

Belief multiplied_out(std::span<const Factor> factors, std::size_t components) {
  Belief all;
  std::vector<std::uint32_t> entries(factors.size());
  while (true) {
    all.push_back(combine(factors, entries, components));
    std::size_t f = factors.size();
    while (f > 0 && ++entries[f - 1] == factors[f - 1].belief->size()) entries[--f] = 0;
    if (f == 0) break;
  }
  put_in_order(all);
  return all;
}

}  // namespace

std::size_t product_size(std::span<const Factor> factors) {
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
  std::size_t size = 1;
  for (const Factor& factor : factors) {
    const std::size_t own = factor.belief->size();
    size = own > 0 && size > most / own ? most : size * own;
  }
  return size;
}

Belief product(std::span<const Factor> factors, std::size_t components, std::size_t most) {
  const std::size_t size = product_size(factors);
  if (size == 0) return {};
  if (std::min(size, most) > most_states) {
    throw TooManyStates("the belief, a product over " + std::to_string(factors.size()) + " groups, has more than " +
                        std::to_string(most_states) + " states");
  }
  if (size <= most) return multiplied_out(factors, components);

  // A factor of one state leaves nothing to choose.
  OptimalSearch::Costs costs;
  std::vector<std::size_t> open;
  for (std::size_t f = 0; f < factors.size(); ++f) {
    if (factors[f].belief->size() == 1) continue;
    open.push_back(f);
    auto& values = costs.emplace_back();
    // A rounded probability may exceed 1 in the last bit.
    for (const BeliefEntry& entry : *factors[f].belief) values.push_back(std::max(0.0, -std::log(entry.probability)));
  }
  OptimalSearch search(costs);
  std::vector<std::uint32_t> entries(factors.size(), 0);
  const auto anything = [](std::span<const std::uint32_t>) -> std::optional<Conflict> { return std::nullopt; };
  Belief head;
  // Ties with the last one are told apart by state; of very many, the first that come.
  const std::size_t enough = 2 * most + 64;
  while (head.size() < enough && search.next(anything) == OptimalSearch::Outcome::solution) {
    for (std::size_t i = 0; i < open.size(); ++i) entries[open[i]] = search.values()[i];
    head.push_back(combine(factors, entries, components));
    if (head.size() > most && head.back().probability < head[most - 1].probability * (1 - tie_tolerance)) break;
  }
  put_in_order(head);
  head.resize(std::min(head.size(), most));
  return head;
}

Belief product_by_modes(std::span<const Factor> factors, std::size_t components, std::size_t most, std::size_t clocks) {
  // Each factor by its modes: beliefs over combinations without clocks, and behind them one for each of these.
  std::deque<Belief> modes;
  std::vector<Combinations> combinations(factors.size());  // none of a factor of one state, which is its own
  std::vector<Factor> by_modes(factors.begin(), factors.end());
  bool one_each = true;
  for (std::size_t f = 0; f < factors.size(); ++f) {
    if (factors[f].belief->size() == 1) continue;
    combinations[f] = combinations_of(*factors[f].belief);
    Belief& belief = modes.emplace_back();
    for (const Combination& combination : combinations[f]) {
      one_each = one_each && combination.clocks.size() == 1;
      belief.push_back({{combination.modes, combination.clocks.front().starts}, combination.probability});
    }
    by_modes[f].belief = &belief;
  }
  const Belief head = product(by_modes, components, most);
  if (one_each) return head;
  Belief result;
  for (const BeliefEntry& best : head) {
    std::vector<Belief> own(factors.size());
    std::vector<Factor> with_clocks;
    with_clocks.reserve(factors.size());
    for (std::size_t f = 0; f < factors.size(); ++f) {
      if (combinations[f].empty()) {
        with_clocks.push_back(factors[f]);
        continue;
      }
      automata::Modes part;
      for (const automata::ComponentId c : factors[f].components) part.push_back(best.state.modes[c.index()]);
      const auto at = std::find_if(combinations[f].begin(), combinations[f].end(),
                                   [&](const Combination& combination) { return combination.modes == part; });
      for (const Clocked& clocked : at->clocks) own[f].push_back({{part, clocked.starts}, clocked.probability});
      with_clocks.push_back({&own[f], factors[f].components});
    }
    const Belief states = product(with_clocks, components, clocks);
    result.insert(result.end(), states.begin(), states.end());
  }
  put_in_order(result);
  return result;
}

}  // namespace rmpl::runtime
