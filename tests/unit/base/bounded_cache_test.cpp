// The bounded cache: what it holds, what it forgets, what it counts, and that it can be switched off.
// SPDX-License-Identifier: MIT
#include "base/bounded_cache.hpp"

#include <gtest/gtest.h>

namespace rmpl::base {
namespace {

using Cache = BoundedCache<std::vector<std::uint64_t>, int>;

TEST(BoundedCache, RemembersAndCounts) {
  Cache cache(10);
  EXPECT_EQ(cache.find({1}), nullptr);
  EXPECT_EQ(cache.add({1}, 7), 7);
  EXPECT_EQ(cache.find_or({1}, [] { return 8; }), 7);
  EXPECT_EQ(cache.find_or({2}, [] { return 8; }), 8);
  EXPECT_EQ(cache.counts().hits, 1u);
  EXPECT_EQ(cache.counts().misses, 2u);
  EXPECT_EQ(cache.counts().evictions, 0u);
  EXPECT_EQ(cache.size(), 2u);
}

TEST(BoundedCache, StaysWithinItsLimit) {
  for (const std::size_t limit : {0u, 1u, 2u, 3u, 100u}) {
    Cache cache(limit);
    for (std::uint64_t key = 0; key < 1000; ++key) {
      cache.add({key}, static_cast<int>(key));
      ASSERT_LE(cache.size(), limit > 0 ? limit : 1);
      ASSERT_EQ(*cache.find({key}), static_cast<int>(key)) << "the last is always known";
    }
    EXPECT_EQ(cache.counts().evictions + cache.size(), 1000u);
  }
}

TEST(BoundedCache, ForgetsWhileCachesAreOff) {
  Cache cache(10);
  cache.add({1}, 7);
  {
    const WithoutCaches off;
    EXPECT_EQ(cache.find({1}), nullptr);
    EXPECT_EQ(cache.add({1}, 8), 8) << "what is found anew stands for what was known";
    EXPECT_EQ(cache.find({1}), nullptr);
    EXPECT_EQ(cache.add({2}, 9), 9);
    EXPECT_EQ(cache.size(), 1u);
  }
  EXPECT_EQ(cache.find({1}), nullptr);
  EXPECT_EQ(*cache.find({2}), 9);
}

TEST(BoundedCache, AnAnswerMayAskForAnother) {
  Cache cache(10);
  const int sum = cache.find_or({1}, [&] { return 1 + cache.find_or({2}, [] { return 2; }); });
  EXPECT_EQ(sum, 3);
  EXPECT_EQ(cache.size(), 2u);
}

}  // namespace
}  // namespace rmpl::base
