// Fuzzes the best-first search: a problem is drawn from the input, and every solution compared with a sorted list of
// all. SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"
#include "tests/fuzz/draws.hpp"

using namespace rmpl::runtime;
using rmpl::fuzz::Draws;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Values = std::vector<std::uint32_t>;

/// Quarters add up exactly, so that ties are ties for both sides.
OptimalSearch::Costs draw_costs(Draws& draws) {
  OptimalSearch::Costs costs(1 + draws.below(4));
  for (auto& values : costs) {
    values.resize(1 + draws.below(3));
    for (double& cost : values) {
      const std::size_t quarters = draws.below(8);
      cost = quarters == 7 ? infinity : 0.25 * static_cast<double>(quarters);
    }
  }
  return costs;
}

std::vector<Conflict> draw_conflicts(const OptimalSearch::Costs& costs, Draws& draws) {
  std::vector<Conflict> conflicts(draws.below(5));
  for (Conflict& conflict : conflicts) {
    for (std::uint32_t x = 0; x < costs.size(); ++x) {
      if (draws.below(2) != 0) conflict.push_back({x, static_cast<std::uint32_t>(draws.below(costs[x].size()))});
    }
  }
  return conflicts;
}

bool holds(const Conflict& conflict, std::span<const std::uint32_t> values) {
  return std::all_of(conflict.begin(), conflict.end(),
                     [&](const Decision& decision) { return values[decision.variable] == decision.value; });
}

const Conflict* broken(const std::vector<Conflict>& conflicts, std::span<const std::uint32_t> values) {
  const auto at = std::find_if(conflicts.begin(), conflicts.end(), [&](const auto& c) { return holds(c, values); });
  return at == conflicts.end() ? nullptr : &*at;
}

/// All solutions, in order of cost, then lexicographically.
std::vector<std::pair<double, Values>> all_solutions(const OptimalSearch::Costs& costs,
                                                     const std::vector<Conflict>& conflicts) {
  std::vector<std::pair<double, Values>> result;
  Values values(costs.size(), 0);
  while (true) {
    double cost = 0;
    for (std::size_t x = 0; x < costs.size(); ++x) cost += costs[x][values[x]];
    if (std::isfinite(cost) && broken(conflicts, values) == nullptr) result.emplace_back(cost, values);
    std::size_t x = costs.size();
    while (x-- > 0 && ++values[x] == costs[x].size()) values[x] = 0;
    if (x == SIZE_MAX) break;
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Draws draws(data, size);
  const OptimalSearch::Costs costs = draw_costs(draws);
  const std::vector<Conflict> conflicts = draw_conflicts(costs, draws);
  // Some are known from the start, and what a search learns serves the next.
  const auto known = std::make_shared<ConflictSet>();
  for (const Conflict& conflict : conflicts) {
    if (draws.below(3) == 0) known->add(conflict);
  }
  const auto check = [&](std::span<const std::uint32_t> candidate) -> std::optional<Conflict> {
    const Conflict* conflict = broken(conflicts, candidate);
    return conflict == nullptr ? std::nullopt : std::optional(*conflict);
  };
  const auto solutions = all_solutions(costs, conflicts);
  for (int search_number = 0; search_number < 2; ++search_number) {
    OptimalSearch search(costs, known);
    const std::size_t budget = draws.below(4);
    const auto next = [&] {
      if (budget == 0) return search.next(check);
      search.set_budget(budget);
      OptimalSearch::Outcome outcome = search.next(check);
      for (; outcome == OptimalSearch::Outcome::budget; outcome = search.next(check)) search.set_budget(budget);
      return outcome;
    };
    for (const auto& [cost, values] : solutions) {
      CHECK(search.bound() <= cost);
      CHECK(next() == OptimalSearch::Outcome::solution);
      CHECK(search.values() == values && search.cost() == cost);
    }
    CHECK(next() == OptimalSearch::Outcome::exhausted);
    CHECK(search.bound() == infinity);
  }
  return 0;
}
