// An optimal constraint satisfaction problem without constraints.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/best_tuples.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "runtime/reasoning/estimate/order.hpp"
#include "runtime/reasoning/estimate/product.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"

namespace rmpl::runtime {
namespace {

Tuple tuple_at(const std::vector<Probabilities>& lists, const std::vector<std::uint32_t>& places) {
  Tuple result{1, places};
  for (std::size_t l = 0; l < lists.size(); ++l) result.probability *= lists[l][places[l]];
  return result;
}

std::vector<Tuple> all_tuples(const std::vector<Probabilities>& lists) {
  std::vector<Tuple> all;
  std::vector<std::uint32_t> places(lists.size());
  while (true) {
    all.push_back(tuple_at(lists, places));
    std::size_t l = lists.size();
    while (l > 0 && ++places[l - 1] == lists[l - 1].size()) places[--l] = 0;
    if (l == 0) return all;
  }
}

}  // namespace

std::vector<Tuple> best_tuples(const std::vector<Probabilities>& lists, std::size_t most) {
  std::size_t size = 1;
  for (const Probabilities& list : lists) {
    if (list.empty()) return {};
    size = std::min(size * list.size(), most_states + 1);
  }
  if (std::min(size, most) > most_states) {
    throw TooManyStates("the belief, a product over " + std::to_string(lists.size()) + " groups, has more than " +
                        std::to_string(most_states) + " states");
  }
  if (size <= most) return all_tuples(lists);
  OptimalSearch::Costs costs;
  for (const Probabilities& list : lists) {
    auto& values = costs.emplace_back();
    // A rounded probability may exceed 1 in the last bit.
    for (const double probability : list) values.push_back(std::max(0.0, -std::log(probability)));
  }
  OptimalSearch search(costs);
  const auto anything = [](std::span<const std::uint32_t>) -> std::optional<Conflict> { return std::nullopt; };
  std::vector<Tuple> head;
  const std::size_t enough = 2 * most + 64;
  while (head.size() < enough && search.next(anything) == OptimalSearch::Outcome::solution) {
    head.push_back(tuple_at(lists, search.values()));
    if (head.size() > most && head.back().probability < head[most - 1].probability * (1 - tie_tolerance)) break;
  }
  return head;
}

}  // namespace rmpl::runtime
