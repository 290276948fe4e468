// Where time ends, sums and products say so.
// SPDX-License-Identifier: MIT
#include "automata/time/checked_ticks.hpp"

#include <gtest/gtest.h>

namespace rmpl::automata {
namespace {

constexpr Ticks last{Ticks::infinite().count - 1};

TEST(CheckedTicks, SumsEndBeforeInfinity) {
  EXPECT_EQ(checked_sum(last, Ticks{0}), last);
  EXPECT_EQ(checked_sum(last, Ticks{1}), std::nullopt);
  EXPECT_EQ(checked_sum(Ticks::of_seconds(5'000'000'000), Ticks::of_seconds(5'000'000'000)), std::nullopt);
  EXPECT_EQ(checked_sum(Ticks::of_seconds(1), Ticks::infinite()), std::nullopt);
}

TEST(CheckedTicks, ProductsEndBeforeInfinity) {
  EXPECT_EQ(checked_product(Ticks::of_seconds(86'400), 100'000), Ticks::of_seconds(8'640'000'000));
  EXPECT_EQ(checked_product(Ticks::of_seconds(86'400), 200'000), std::nullopt);
  EXPECT_EQ(checked_product(Ticks{1}, static_cast<std::uint64_t>(last.count)), last);
  EXPECT_EQ(checked_product(Ticks{1}, static_cast<std::uint64_t>(last.count) + 1), std::nullopt);
  EXPECT_EQ(checked_product(Ticks{0}, ~std::uint64_t{0}), Ticks{0});
}

}  // namespace
}  // namespace rmpl::automata
