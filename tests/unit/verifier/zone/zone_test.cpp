// Zones against sets of integer points.
// SPDX-License-Identifier: MIT
#include "verifier/zone/zone.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <set>

#include "verifier/zone/covering.hpp"
#include "verifier/zone/union.hpp"

namespace rmpl::verifier {
namespace {

constexpr std::size_t clocks = 3;
constexpr Units side = 14;  ///< points are looked at with coordinates 0 … side - 1
using Point = std::vector<Units>;
using Points = std::set<Point>;

void for_each_point(const std::function<void(const Point&)>& visit) {
  for (Units x = 0; x < side; ++x)
    for (Units y = 0; y < side; ++y)
      for (Units z = 0; z < side; ++z) visit({x, y, z});
}

Points points_of(const Zone& zone) {
  Points result;
  for_each_point([&](const Point& p) {
    if (zone.contains(p)) result.insert(p);
  });
  return result;
}

Points filtered(const Points& points, const std::function<bool(const Point&)>& keep) {
  Points result;
  for (const Point& p : points)
    if (keep(p)) result.insert(p);
  return result;
}

/// A zone that some random run of operations makes, with at least one point well inside the cube.
Zone random_zone(std::mt19937& random) {
  const auto draw = [&](Units most) { return std::uniform_int_distribution<Units>(0, most)(random); };
  while (true) {
    Zone zone(clocks);
    bool empty = false;
    for (int operation = 0; operation < 4 && !empty; ++operation) {
      zone.elapse();
      const auto clock = static_cast<std::size_t>(1 + draw(clocks - 1));
      const Units lower = draw(3);
      empty = !zone.constrain(clock, {lower, lower + draw(3)});
      if (empty) break;
      std::vector<std::size_t> sources = {1, 2, 3};
      sources[static_cast<std::size_t>(draw(2))] = static_cast<std::size_t>(draw(3));
      zone = zone.select(sources);
    }
    if (!empty) return zone;
  }
}

bool is_canonical(const Zone& zone) {
  for (std::size_t i = 0; i <= clocks; ++i)
    for (std::size_t j = 0; j <= clocks; ++j)
      for (std::size_t k = 0; k <= clocks; ++k) {
        const Units a = zone.bound(i, k);
        const Units b = zone.bound(k, j);
        if (a != unbounded && b != unbounded && zone.bound(i, j) > a + b) return false;
      }
  return true;
}

TEST(Zone, StartsAtZero) { EXPECT_EQ(points_of(Zone(clocks)), Points({{0, 0, 0}})); }

TEST(Zone, ConstrainKeepsThePointsWithin) {
  std::mt19937 random(1);
  for (int round = 0; round < 60; ++round) {
    Zone zone = random_zone(random);
    zone.elapse();
    const Points before = points_of(zone);
    const auto draw = [&](Units least, Units most) {
      return std::uniform_int_distribution<Units>(least, most)(random);
    };
    const auto i = static_cast<std::size_t>(draw(0, clocks));
    const auto j = static_cast<std::size_t>(draw(0, clocks));
    if (i == j) continue;
    const Units bound = draw(-4, 6);
    const Points expected =
        filtered(before, [&](const Point& p) { return (i == 0 ? 0 : p[i - 1]) - (j == 0 ? 0 : p[j - 1]) <= bound; });
    const bool left = zone.constrain(i, j, bound);
    if (!left) {
      EXPECT_TRUE(expected.empty());
    } else {
      EXPECT_EQ(points_of(zone), expected);
      EXPECT_TRUE(is_canonical(zone));
    }
  }
}

TEST(Zone, TimePassesForAllClocksAlike) {
  std::mt19937 random(2);
  for (int round = 0; round < 40; ++round) {
    const Zone zone = random_zone(random);
    Points later;
    Points next;
    for (const Point& p : points_of(zone)) {
      next.insert({p[0] + 1, p[1] + 1, p[2] + 1});
      for (Units d = 0; d < side; ++d) later.insert({p[0] + d, p[1] + d, p[2] + d});
    }
    const auto inside = [](const Point& p) { return *std::max_element(p.begin(), p.end()) < side; };
    Zone elapsed = zone;
    elapsed.elapse();
    EXPECT_EQ(points_of(elapsed), filtered(later, inside));
    EXPECT_TRUE(is_canonical(elapsed));
    Zone ticked = zone;
    ticked.tick();
    EXPECT_EQ(points_of(ticked), filtered(next, inside));
    EXPECT_TRUE(is_canonical(ticked));
  }
}

TEST(Zone, SelectReordersForgetsAndRestarts) {
  std::mt19937 random(3);
  for (int round = 0; round < 40; ++round) {
    Zone zone = random_zone(random);
    const std::vector<std::size_t> sources = {3, 0, 1};
    Points expected;
    for (const Point& p : points_of(zone)) expected.insert({p[2], 0, p[0]});
    const Zone selected = zone.select(sources);
    EXPECT_EQ(points_of(selected), expected);
    EXPECT_TRUE(is_canonical(selected));
  }
}

TEST(Zone, InclusionIsThatOfThePoints) {
  std::mt19937 random(4);
  int included = 0;
  for (int round = 0; round < 400; ++round) {
    const Zone a = random_zone(random);
    const Zone b = random_zone(random);
    const Points in_a = points_of(a);
    const Points in_b = points_of(b);
    const bool subset = std::includes(in_a.begin(), in_a.end(), in_b.begin(), in_b.end());
    EXPECT_EQ(a.includes(b), subset);
    included += subset ? 1 : 0;
  }
  EXPECT_GT(included, 0);
}

TEST(Union, HoldsAZoneExactlyIfItHoldsItsPoints) {
  std::mt19937 random(7);
  int counts[2] = {};
  for (int round = 0; round < 2000; ++round) {
    std::vector<Zone> parts = {random_zone(random), random_zone(random), random_zone(random)};
    const Zone both = hull(parts[0], parts[1]);
    EXPECT_TRUE(is_canonical(both));
    EXPECT_TRUE(both.includes(parts[0]) && both.includes(parts[1]));
    const bool inside = both.upper(1) < side && both.upper(2) < side && both.upper(3) < side;
    if (!inside) continue;
    Points together;
    for (const Zone& part : parts) together.merge(points_of(part));
    const Points all = points_of(both);
    const bool holds = std::includes(together.begin(), together.end(), all.begin(), all.end());
    EXPECT_EQ(within_union(both, parts, 1000), holds);
    EXPECT_FALSE(within_union(both, parts, 0));
    ++counts[holds ? 1 : 0];
    const Points first = points_of(parts[0]);
    const Points second = points_of(parts[1]);
    const bool apart = std::none_of(first.begin(), first.end(), [&](const Point& p) { return second.contains(p); });
    EXPECT_TRUE(apart || !disjoint(parts[0], parts[1]));
  }
  EXPECT_GT(counts[0], 100);
  EXPECT_GT(counts[1], 100);
}

/// One of three clocks started last, whichever: pieces of which no two make a zone, and all three do.
TEST(Union, NeedsMoreThanTwoPieces) {
  Zone all(clocks);
  for (std::size_t clock = 1; clock <= clocks; ++clock) {
    all.elapse();
    std::vector<std::size_t> sources = {1, 2, 3};
    sources[clock - 1] = 0;
    all = hull(all, all.select(sources));
  }
  std::vector<Zone> pieces;
  for (std::size_t last = 1; last <= clocks; ++last) {
    Zone piece = all;
    for (std::size_t other = 1; other <= clocks; ++other) ASSERT_TRUE(other == last || piece.constrain(last, other, 0));
    pieces.push_back(piece);
  }
  EXPECT_TRUE(within_union(all, pieces, 100));
  EXPECT_TRUE(within_union(hull(pieces[0], pieces[1]), pieces, 100));
  for (std::size_t left_out = 0; left_out < clocks; ++left_out) {
    std::vector<Zone> two = pieces;
    two.erase(two.begin() + static_cast<std::ptrdiff_t>(left_out));
    EXPECT_FALSE(within_union(hull(two[0], two[1]), two, 100));
  }
}

/// Every point that extrapolation adds is simulated by one of the zone: it agrees with it on each clock, or both are
/// beyond what the clock is compared with from the side that would tell them apart.
TEST(Zone, ExtrapolationAddsOnlyWhatCannotBeToldApart) {
  std::mt19937 random(5);
  const auto draw = [&](Units most) { return std::uniform_int_distribution<Units>(-1, most)(random); };
  for (int round = 0; round < 60; ++round) {
    Zone zone = random_zone(random);
    if (round % 2 == 0) zone.elapse();
    const std::vector<ClockLimits> limits = {{draw(4), draw(4)}, {draw(4), draw(4)}, {draw(4), draw(4)}};
    Zone wide = zone;
    wide.extrapolate(limits);
    EXPECT_TRUE(wide.includes(zone));
    EXPECT_TRUE(is_canonical(wide));
    const Points exact = points_of(zone);
    for (const Point& added : points_of(wide)) {
      // Points of the zone beyond the cube could be what simulates this one.
      if (*std::max_element(added.begin(), added.end()) > 8) continue;
      const bool simulated = std::any_of(exact.begin(), exact.end(), [&](const Point& p) {
        for (std::size_t c = 0; c < clocks; ++c) {
          const bool above = limits[c].lower < p[c] && p[c] < added[c];
          const bool below = limits[c].upper < added[c] && added[c] < p[c];
          if (p[c] != added[c] && !above && !below) return false;
        }
        return true;
      });
      EXPECT_TRUE(simulated) << added[0] << ' ' << added[1] << ' ' << added[2];
    }
  }
}

/// One zone covers another exactly if every point of it is simulated by a point of the one: it agrees with it on each
/// clock, or both are beyond what the clock is compared with from the side that would tell them apart.
TEST(Covering, IsThatOfSimulatedPoints) {
  std::mt19937 random(6);
  const auto draw = [&](Units most) { return std::uniform_int_distribution<Units>(-1, most)(random); };
  const auto inside = [](const Zone& zone) {
    return zone.upper(1) < side && zone.upper(2) < side && zone.upper(3) < side;
  };
  int counts[2][2] = {};
  for (int round = 0; round < 3000; ++round) {
    const Zone a = random_zone(random);
    const Zone b = random_zone(random);
    if (!inside(a) || !inside(b)) continue;
    const std::vector<ClockLimits> limits = {{draw(8), draw(8)}, {draw(8), draw(8)}, {draw(8), draw(8)}};
    const Points larger = points_of(a);
    const Points smaller = points_of(b);
    const bool covered = std::all_of(smaller.begin(), smaller.end(), [&](const Point& v) {
      return std::any_of(larger.begin(), larger.end(), [&](const Point& p) {
        for (std::size_t c = 0; c < clocks; ++c) {
          const bool above = limits[c].lower < p[c] && p[c] < v[c];
          const bool below = limits[c].upper < v[c] && v[c] < p[c];
          if (p[c] != v[c] && !above && !below) return false;
        }
        return true;
      });
    });
    EXPECT_EQ(covers(a.matrix().data(), b.matrix().data(), clocks + 1, limits), covered);
    const bool included = includes(a.matrix().data(), b.matrix().data(), clocks + 1);
    EXPECT_EQ(included, a.includes(b));
    ++counts[covered ? 1 : 0][included ? 1 : 0];
  }
  EXPECT_GT(counts[0][0], 100);
  EXPECT_GT(counts[1][0], 100);
  EXPECT_GT(counts[1][1], 10);
}

TEST(Interval, MergedJoinsWhatTouches) {
  EXPECT_EQ(merged({{5, 9}, {0, 3}, {4, 4}, {12, unbounded}, {20, 30}, {7, 6}}),
            (std::vector<Interval>{{0, 9}, {12, unbounded}}));
  EXPECT_TRUE(intersection({0, 3}, {4, 9}).empty());
}

}  // namespace
}  // namespace rmpl::verifier
