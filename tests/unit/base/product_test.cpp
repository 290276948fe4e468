// Multiplying out: order, pruning, and an early end.
// SPDX-License-Identifier: MIT
#include "base/product.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace rmpl::base {
namespace {

const std::vector<std::string> lists = {"ab", "xyz", "12"};

/// What is visited, in order; `most` ends it, options that are in `refused` are not taken.
std::vector<std::string> visited(std::size_t most, const std::string& refused) {
  std::vector<std::string> result;
  std::string taken;
  multiply_out(
      lists,
      [&](std::size_t l, std::size_t i) {
        if (refused.find(lists[l][i]) != std::string::npos) return false;
        taken += lists[l][i];
        return true;
      },
      [&](std::size_t, std::size_t) { taken.pop_back(); },
      [&] {
        result.push_back(taken);
        return result.size() == most;
      });
  return result;
}

TEST(MultiplyOut, TheFirstListIsOutermost) {
  EXPECT_EQ(visited(99, "").size(), 12U);
  EXPECT_EQ(visited(4, ""), (std::vector<std::string>{"ax1", "ax2", "ay1", "ay2"}));
}

TEST(MultiplyOut, WhatIsRefusedIsLeftOut) {
  EXPECT_EQ(visited(99, "az2"), (std::vector<std::string>{"bx1", "by1"}));
  EXPECT_TRUE(visited(99, "12").empty());
}

TEST(MultiplyOut, WhatIsTakenIsPutBack) {
  for (const std::size_t most : {std::size_t{3}, std::size_t{99}}) {
    std::vector<std::pair<std::size_t, std::size_t>> taken;
    std::size_t visits = 0;
    const bool ended = multiply_out(
        lists,
        [&](std::size_t l, std::size_t i) {
          EXPECT_EQ(taken.size(), l);
          taken.emplace_back(l, i);
          return true;
        },
        [&](std::size_t l, std::size_t i) {
          EXPECT_EQ(taken.back(), std::pair(l, i));
          taken.pop_back();
        },
        [&] { return ++visits == most; });
    EXPECT_EQ(ended, most == 3);
    EXPECT_TRUE(taken.empty());
  }
}

TEST(MultiplyOut, ManyListsTakeNoStack) {
  const std::vector<std::string> many(1'000'000, "a");
  std::size_t taken = 0;
  EXPECT_TRUE(multiply_out(
      many, [&](std::size_t, std::size_t) { return ++taken > 0; }, [&](std::size_t, std::size_t) { --taken; },
      [&] { return taken == many.size(); }));
  EXPECT_EQ(taken, 0U);
}

TEST(MultiplyOut, OfNoListsThereIsOneWay) {
  int ways = 0;
  for_each_combination(std::vector<std::vector<int>>{}, [&](const std::vector<int>& taken) {
    EXPECT_TRUE(taken.empty());
    ++ways;
  });
  EXPECT_EQ(ways, 1);
  for_each_combination(std::vector<std::vector<int>>{{1, 2}, {}}, [&](const std::vector<int>&) { ++ways; });
  EXPECT_EQ(ways, 1);
}

}  // namespace
}  // namespace rmpl::base
