// Fuzzes zones as a sequence of calls: what is done to them, and asked of them, is drawn from the input, and done to
// the set of their readings, one by one, as well.
//
// Readings stay within a small cube, to which every zone is cut back: so the set is all that the zone holds.
// SPDX-License-Identifier: MIT
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/check.hpp"
#include "tests/fuzz/draws.hpp"
#include "verifier/zone/covering.hpp"
#include "verifier/zone/union.hpp"
#include "verifier/zone/zone.hpp"

using namespace rmpl::verifier;
using rmpl::fuzz::Draws;

namespace {

constexpr std::size_t clocks = 3;
constexpr Units side = 5;
constexpr std::size_t point_count = side * side * side;
using Point = std::array<Units, clocks>;
using Points = std::bitset<point_count>;

Point point(std::size_t number) {
  const auto n = static_cast<Units>(number);
  return {n / (side * side), n / side % side, n % side};
}

std::size_t number_of(const Point& p) { return static_cast<std::size_t>((p[0] * side + p[1]) * side + p[2]); }

bool in_cube(const Point& p) {
  return p[0] >= 0 && p[0] < side && p[1] >= 0 && p[1] < side && p[2] >= 0 && p[2] < side;
}

template <class Keep>
Points filtered(const Points& points, const Keep& keep) {
  Points result;
  for (std::size_t n = 0; n < point_count; ++n) result[n] = points[n] && keep(point(n));
  return result;
}

template <class Map>
Points mapped(const Points& points, const Map& map) {
  Points result;
  for (std::size_t n = 0; n < point_count; ++n) {
    if (!points[n]) continue;
    const Point to = map(point(n));
    if (in_cube(to)) result.set(number_of(to));
  }
  return result;
}

/// A zone, and the readings in it.
struct Pair {
  Zone zone{clocks};
  Points points = Points{}.set(0);
};

bool within_cube(Zone& zone) {
  for (std::size_t clock = 1; clock <= clocks; ++clock) {
    if (!zone.constrain(clock, {0, side - 1})) return false;
  }
  return true;
}

/// Every bound is attained, and the readings are those of the set.
void check(const Pair& pair) {
  std::array<std::array<Units, clocks + 1>, clocks + 1> greatest;
  for (auto& row : greatest) row.fill(-side);
  for (std::size_t n = 0; n < point_count; ++n) {
    const Point p = point(n);
    CHECK(pair.zone.contains(p) == pair.points[n]);
    if (!pair.points[n]) continue;
    const auto value = [&](std::size_t clock) { return clock == 0 ? 0 : p[clock - 1]; };
    for (std::size_t i = 0; i <= clocks; ++i) {
      for (std::size_t j = 0; j <= clocks; ++j) greatest[i][j] = std::max(greatest[i][j], value(i) - value(j));
    }
  }
  for (std::size_t i = 0; i <= clocks; ++i) {
    for (std::size_t j = 0; j <= clocks; ++j) CHECK(pair.zone.bound(i, j) == greatest[i][j]);
  }
}

/// What one operation leaves of the pair; where nothing is left the pair starts anew.
void change(Pair& pair, Draws& draws) {
  bool left = true;
  switch (draws.below(5)) {
    case 0: {
      pair.zone.elapse();
      Points later = pair.points;
      for (Units step = 1; step < side; ++step) {
        later |= mapped(later, [](Point p) { return Point{p[0] + 1, p[1] + 1, p[2] + 1}; });
      }
      pair.points = later;
      break;
    }
    case 1: {
      pair.zone.tick();
      pair.points = mapped(pair.points, [](Point p) { return Point{p[0] + 1, p[1] + 1, p[2] + 1}; });
      break;
    }
    case 2: {
      const std::size_t clock = draws.below(clocks);
      const Interval interval{static_cast<Units>(draws.below(side)), static_cast<Units>(draws.below(side))};
      left = pair.zone.constrain(clock + 1, interval);
      pair.points = filtered(pair.points, [&](const Point& p) { return interval.contains(p[clock]); });
      break;
    }
    case 3: {
      const std::size_t i = draws.below(clocks);
      const std::size_t j = (i + 1 + draws.below(clocks - 1)) % clocks;
      const Units bound = static_cast<Units>(draws.below(2 * side)) - side;
      left = pair.zone.constrain(i + 1, j + 1, bound);
      pair.points = filtered(pair.points, [&](const Point& p) { return p[i] - p[j] <= bound; });
      break;
    }
    default: {
      std::array<std::size_t, clocks> sources{};
      for (std::size_t& source : sources) source = draws.below(clocks + 1);
      pair.zone = pair.zone.select(sources);
      pair.points = mapped(pair.points, [&](const Point& p) {
        Point result{};
        for (std::size_t clock = 0; clock < clocks; ++clock) {
          if (sources[clock] != 0) result[clock] = p[sources[clock] - 1];
        }
        return result;
      });
    }
  }
  left = left && within_cube(pair.zone);
  CHECK(left == pair.points.any());
  if (!left) pair = Pair{};
  check(pair);
}

/// Whether some reading of `larger` can do all that each of `smaller` can, by the definition.
bool simulates(const Points& larger, const Points& smaller, const std::array<ClockLimits, clocks>& limits) {
  for (std::size_t s = 0; s < point_count; ++s) {
    if (!smaller[s]) continue;
    const Point p = point(s);
    bool found = false;
    for (std::size_t l = 0; l < point_count && !found; ++l) {
      if (!larger[l]) continue;
      const Point q = point(l);
      found = true;
      for (std::size_t x = 0; x < clocks; ++x) {
        found = found &&
                (q[x] == p[x] || (limits[x].lower < q[x] && q[x] < p[x]) || (limits[x].upper < p[x] && p[x] < q[x]));
      }
    }
    if (!found) return false;
  }
  return true;
}

void ask(const Pair& a, const Pair& b, const Pair& c, Draws& draws) {
  switch (draws.below(4)) {
    case 0:
      CHECK(a.zone.includes(b.zone) == (b.points & ~a.points).none());
      CHECK(disjoint(a.zone, b.zone) == (a.points & b.points).none());
      break;
    case 1: {
      const Zone both = hull(a.zone, b.zone);
      Pair together{both, Points{}};
      for (std::size_t n = 0; n < point_count; ++n) together.points[n] = both.contains(point(n));
      CHECK((a.points & ~together.points).none() && (b.points & ~together.points).none());
      check(together);
      break;
    }
    case 2: {
      const std::vector<Zone> parts = {b.zone, c.zone};
      const bool within = (a.points & ~(b.points | c.points)).none();
      CHECK(within_union(a.zone, parts, 1000) == within);
      CHECK(!within_union(a.zone, parts, draws.below(4)) || within);
      break;
    }
    default: {
      std::array<ClockLimits, clocks> limits;
      for (ClockLimits& limit : limits) {
        limit = {static_cast<Units>(draws.below(side + 1)) - 1, static_cast<Units>(draws.below(side + 1)) - 1};
      }
      const Units* larger = a.zone.matrix().data();
      const Units* smaller = b.zone.matrix().data();
      CHECK(covers(larger, smaller, clocks + 1, limits) == simulates(a.points, b.points, limits));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Draws draws(data, size);
  std::array<Pair, 3> pairs;
  for (int calls = 0; calls < 40 && !draws.empty(); ++calls) {
    Pair& one = pairs[draws.below(pairs.size())];
    switch (draws.below(4)) {
      case 0:
        one = pairs[draws.below(pairs.size())];
        break;
      case 1:
        ask(one, pairs[draws.below(pairs.size())], pairs[draws.below(pairs.size())], draws);
        break;
      default:
        change(one, draws);
    }
  }
  return 0;
}
