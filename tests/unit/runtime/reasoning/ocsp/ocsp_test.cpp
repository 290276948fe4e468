// Optimal constraint satisfaction against enumeration of all assignments.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/ocsp/ocsp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace rmpl::runtime {
namespace {

using Values = std::vector<std::uint32_t>;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Every assignment of finite cost that contains none of the conflicts, in order of cost, then lexicographically.
std::vector<std::pair<double, Values>> enumerate(const OptimalSearch::Costs& costs,
                                                 const std::vector<Conflict>& conflicts) {
  std::vector<std::pair<double, Values>> all;
  Values values(costs.size());
  const auto visit = [&](const auto& self, std::size_t x, double cost) -> void {
    if (x == costs.size()) {
      const bool allowed = std::none_of(conflicts.begin(), conflicts.end(), [&](const Conflict& c) {
        return std::all_of(c.begin(), c.end(), [&](const Decision& d) { return values[d.variable] == d.value; });
      });
      if (allowed) all.emplace_back(cost, values);
      return;
    }
    for (std::uint32_t v = 0; v < costs[x].size(); ++v) {
      values[x] = v;
      if (std::isfinite(costs[x][v])) self(self, x + 1, cost + costs[x][v]);
    }
  };
  visit(visit, 0, 0);
  std::sort(all.begin(), all.end());
  return all;
}

TEST(OptimalSearch, EnumeratesLikeSortingDoes) {
  std::mt19937 random(7);
  const auto draw = [&](std::size_t below) { return static_cast<std::uint32_t>(random() % below); };
  for (int round = 0; round < 300; ++round) {
    // Quarters add up exactly, so that ties are ties for both sides.
    OptimalSearch::Costs costs(1 + draw(5));
    for (auto& values : costs) {
      values.resize(1 + draw(4));
      for (double& cost : values) cost = draw(9) == 0 ? infinity : 0.25 * draw(6);
    }
    std::vector<Conflict> conflicts(draw(6));
    for (Conflict& conflict : conflicts) {
      for (std::uint32_t x = 0; x < costs.size(); ++x) {
        if (draw(2) == 0) conflict.push_back({x, draw(costs[x].size())});
      }
      if (conflict.empty()) conflict.push_back({0, 0});
    }
    std::set<Values> checked;
    const auto check = [&](std::span<const std::uint32_t> candidate) -> std::optional<Conflict> {
      EXPECT_TRUE(checked.emplace(candidate.begin(), candidate.end()).second) << "a candidate is checked once";
      for (const Conflict& c : conflicts) {
        if (std::all_of(c.begin(), c.end(), [&](const Decision& d) { return candidate[d.variable] == d.value; })) {
          return c;
        }
      }
      return std::nullopt;
    };
    OptimalSearch search(costs);
    for (const auto& [cost, values] : enumerate(costs, conflicts)) {
      EXPECT_LE(search.bound(), cost);
      ASSERT_EQ(search.next(check), OptimalSearch::Outcome::solution);
      EXPECT_EQ(search.values(), values);
      EXPECT_DOUBLE_EQ(search.cost(), cost);
    }
    EXPECT_EQ(search.next(check), OptimalSearch::Outcome::exhausted);
    EXPECT_EQ(search.bound(), infinity);
    EXPECT_EQ(search.checked(), checked.size());
  }
}

TEST(OptimalSearch, ChecksNothingThatHoldsAKnownConflict) {
  const OptimalSearch::Costs costs(12, {0, 1});
  const auto conflicts = std::make_shared<ConflictSet>();
  conflicts->add({{3, 0}});
  OptimalSearch search(costs, conflicts);
  const auto check = [](std::span<const std::uint32_t> candidate) -> std::optional<Conflict> {
    EXPECT_EQ(candidate[3], 1u);
    if (candidate[7] == 0) return Conflict{{7, 0}};
    return std::nullopt;
  };
  ASSERT_EQ(search.next(check), OptimalSearch::Outcome::solution);
  EXPECT_EQ(search.checked(), 2u);
  EXPECT_EQ(search.cost(), 2.0);
  EXPECT_EQ(conflicts->conflicts().size(), 2u);
}

TEST(OptimalSearch, StopsAtItsBudgetAndGoesOn) {
  const OptimalSearch::Costs costs(3, {0, 1});
  OptimalSearch search(costs);
  const auto all_but_last = [](std::span<const std::uint32_t> candidate) -> std::optional<Conflict> {
    if (std::count(candidate.begin(), candidate.end(), 1u) == 3) return std::nullopt;
    Conflict conflict;
    for (std::uint32_t x = 0; x < 3; ++x) conflict.push_back({x, candidate[x]});
    return conflict;
  };
  search.set_budget(7);
  EXPECT_EQ(search.next(all_but_last), OptimalSearch::Outcome::budget);
  EXPECT_EQ(search.checked(), 7u);
  search.set_budget(1);
  EXPECT_EQ(search.next(all_but_last), OptimalSearch::Outcome::solution);
  EXPECT_EQ(search.next(all_but_last), OptimalSearch::Outcome::exhausted);
}

TEST(OptimalSearch, AnEmptyConflictEndsIt) {
  OptimalSearch search({{0, 1}, {0, 1}});
  const auto nothing = [](std::span<const std::uint32_t>) -> std::optional<Conflict> { return Conflict{}; };
  EXPECT_EQ(search.next(nothing), OptimalSearch::Outcome::exhausted);
  EXPECT_EQ(search.checked(), 1u);
}

TEST(OptimalSearch, AVariableWithoutValuesHasNoSolution) {
  OptimalSearch search({{0, 1}, {infinity}});
  const auto anything = [](std::span<const std::uint32_t>) -> std::optional<Conflict> { return std::nullopt; };
  EXPECT_EQ(search.next(anything), OptimalSearch::Outcome::exhausted);
}

TEST(OptimalSearch, EqualSumsTieWhateverTheOrderOfTheirTerms) {
  // 0.1 + 0.2 + 0.3 and 0.3 + 0.2 + 0.1 differ as doubles.
  OptimalSearch search({{0, 0.3}, {0, 0.2}, {0, 0.1}, {0, 0.1}, {0, 0.2}, {0, 0.3}});
  const auto halves = [](std::span<const std::uint32_t> c) -> std::optional<Conflict> {
    const bool left = c[0] == 1 && c[1] == 1 && c[2] == 1 && c[3] + c[4] + c[5] == 0;
    const bool right = c[0] + c[1] + c[2] == 0 && c[3] == 1 && c[4] == 1 && c[5] == 1;
    if (left || right) return std::nullopt;
    Conflict conflict;
    for (std::uint32_t x = 0; x < 6; ++x) conflict.push_back({x, c[x]});
    return conflict;
  };
  ASSERT_EQ(search.next(halves), OptimalSearch::Outcome::solution);
  EXPECT_EQ(search.values(), (Values{0, 0, 0, 1, 1, 1}));
  ASSERT_EQ(search.next(halves), OptimalSearch::Outcome::solution);
  EXPECT_EQ(search.values(), (Values{1, 1, 1, 0, 0, 0}));
}

}  // namespace
}  // namespace rmpl::runtime
