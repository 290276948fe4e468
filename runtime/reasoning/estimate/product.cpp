// Products of beliefs, best first: an optimal constraint satisfaction problem without constraints.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/product.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "runtime/reasoning/estimate/belief.hpp"
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

  OptimalSearch::Costs costs;
  for (const Factor& factor : factors) {
    auto& values = costs.emplace_back();
    // A rounded probability may exceed 1 in the last bit.
    for (const BeliefEntry& entry : *factor.belief) values.push_back(std::max(0.0, -std::log(entry.probability)));
  }
  OptimalSearch search(costs);
  const auto anything = [](std::span<const std::uint32_t>) -> std::optional<Conflict> { return std::nullopt; };
  Belief head;
  // Ties with the last one are told apart by state; of very many, the first that come.
  const std::size_t enough = 2 * most + 64;
  while (head.size() < enough && search.next(anything) == OptimalSearch::Outcome::solution) {
    head.push_back(combine(factors, search.values(), components));
    if (head.size() > most && head.back().probability < head[most - 1].probability * (1 - tie_tolerance)) break;
  }
  put_in_order(head);
  head.resize(std::min(head.size(), most));
  return head;
}

}  // namespace rmpl::runtime
