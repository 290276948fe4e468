// Neighbouring clocks, cheapest first.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/clock_merging.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "automata/clock_use.hpp"
#include "automata/step/transition_rules.hpp"

namespace rmpl::runtime {

using automata::ModeId;
using automata::Ticks;
using automata::Timing;

namespace {

/// Beyond a survival of so little nothing is looked at; it is part of the bound.
constexpr double negligible = 1e-9;

/// A bound of the greatest difference of the survivals of two clocks, of which the second is the older one. It rises to
/// one peak, and both survivals fall.
double greatest_difference(const Timing& timing, Ticks young, Ticks old) {
  struct Point {
    Ticks time;
    double young, old;
    [[nodiscard]] double difference() const { return std::abs(young - old); }
  };
  const auto at = [&](Ticks t) {
    return Point{t, timing.step_survival(young, young + t), timing.step_survival(old, old + t)};
  };
  Point low = at(std::max(Ticks{}, timing.lower - old));
  Point high;
  if (!timing.upper.is_infinite()) {
    if (old >= timing.upper) return young >= timing.upper ? 0 : 1;
    high = at(timing.upper - old);
  } else {
    high = at(std::max(low.time + low.time, Ticks{Ticks::per_second}));
    while (high.young > negligible && high.time.count < Ticks::infinite().count / 4) high = at(high.time + high.time);
  }
  double greatest = std::max(low.difference(), high.difference());
  while (true) {
    const double bound = std::max({greatest, low.young - high.old, low.old - high.young});
    constexpr double margin = 1e-3;
    const std::int64_t third = (high.time - low.time).count / 3;
    if (third == 0 || bound <= greatest * (1 + margin) + negligible) return std::min(1.0, bound + negligible);
    const Point left = at(low.time + Ticks{third});
    const Point right = at(high.time - Ticks{third});
    greatest = std::max({greatest, left.difference(), right.difference()});
    // Where nothing differs the peak lies behind survivals of 1, and before those of 0.
    constexpr double half = 0.5;
    const bool flat = left.difference() == right.difference();
    if (flat ? left.young > half : left.difference() < right.difference()) {
      low = left;
    } else {
      high = right;
    }
  }
}

}  // namespace

double ClockMerging::distance(std::size_t component, ModeId mode, Ticks a, Ticks b, Ticks now) const {
  if (a == b) return 0;
  if (excluding_[component]) return 1;
  const automata::Component& own = plant_.components[component];
  double sum = 0;
  std::vector<std::uint32_t> branches;  // those of one branch are one risk
  for (const automata::Transition& t : own.transitions) {
    if (t.from != mode || !automata::can_ever_be_taken(t)) continue;
    // As long as it is taken it closes the exits, and clocks go on: what they promise afterwards may be anything.
    if (t.to == mode && !t.timing && !own.is_fault(t)) return 1;
    if (!automata::needs_clock(t)) continue;
    if (!t.guard.is_true() || own.is_fault(t)) return 1;
    if (std::find(branches.begin(), branches.end(), t.branch) != branches.end()) continue;
    branches.push_back(t.branch);
    sum += greatest_difference(*t.timing, now - std::max(a, b), now - std::min(a, b));
    if (sum >= 1) return 1;
  }
  return sum;
}

/// Two clocks by place, and what merging them costs.
struct ClockMerging::Pair {
  std::size_t first, second;
  double cost;
};

std::vector<ClockMerging::Pair> ClockMerging::neighbours(const Combination& combination,
                                                         const std::vector<std::size_t>& varied, Ticks now) const {
  const std::vector<Clocked>& clocks = combination.clocks;
  std::vector<Pair> pairs;
  std::vector<std::size_t> order(clocks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Side by side in memory: they are compared again and again.
  std::vector<Ticks> starts;
  starts.reserve(clocks.size() * varied.size());
  for (const Clocked& clocked : clocks) {
    for (const std::size_t c : varied) starts.push_back(clocked.starts[c]);
  }
  const auto start = [rows = starts.data(), width = varied.size()](std::size_t i, std::size_t v) {
    return rows[i * width + v];
  };
  const auto cost = [&](std::size_t i, std::size_t j, double distance) {
    return std::min(clocks[i].probability, clocks[j].probability) * std::min(distance, 1.0);
  };
  // Those that differ in one component, side by side in its order.
  for (std::size_t last = 0; last < varied.size(); ++last) {
    const auto alike = [start, last, width = varied.size()](std::size_t i, std::size_t j) {
      for (std::size_t v = 0; v < width; ++v) {
        if (v != last && start(i, v) != start(j, v)) return false;
      }
      return true;
    };
    std::sort(order.begin(), order.end(), [start, last, width = varied.size()](std::size_t i, std::size_t j) {
      for (std::size_t v = 0; v < width; ++v) {
        if (v != last && start(i, v) != start(j, v)) return start(i, v) < start(j, v);
      }
      return start(i, last) < start(j, last);
    });
    const std::size_t component = varied[last];
    for (std::size_t k = 1; k < order.size(); ++k) {
      const std::size_t i = order[k - 1], j = order[k];
      if (!alike(i, j)) continue;
      const double apart = distance(component, combination.modes[component], start(i, last), start(j, last), now);
      pairs.push_back({i, j, cost(i, j, apart)});
    }
  }
  if (!pairs.empty()) return pairs;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const std::size_t i = order[k - 1], j = order[k];
    double apart = 0;
    for (const std::size_t c : varied) {
      apart += distance(c, combination.modes[c], clocks[i].starts[c], clocks[j].starts[c], now);
    }
    pairs.push_back({i, j, cost(i, j, apart)});
  }
  return pairs;
}

double ClockMerging::limit(Combination& combination, std::size_t most, Ticks now) const {
  std::vector<Clocked>& clocks = combination.clocks;
  if (clocks.size() <= most) return 0;
  std::vector<std::size_t> varied;
  find_differing(combination, clocks_, varied);
  most *= varied.size();
  if (clocks.size() <= most) return 0;
  const std::size_t enough = most - most / 8;
  double changed = 0;
  while (clocks.size() > enough) {
    std::vector<Pair> pairs = neighbours(combination, varied, now);
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.cost < b.cost; });
    std::vector<bool> touched(clocks.size(), false), gone(clocks.size(), false);
    std::size_t left = clocks.size();
    for (const Pair& pair : pairs) {
      if (left == enough) break;
      if (touched[pair.first] || touched[pair.second]) continue;
      touched[pair.first] = touched[pair.second] = true;
      const bool first_stays = clocks[pair.first].probability >= clocks[pair.second].probability;
      const std::size_t stays = first_stays ? pair.first : pair.second;
      const std::size_t goes = first_stays ? pair.second : pair.first;
      clocks[stays].probability += clocks[goes].probability;
      gone[goes] = true;
      changed += pair.cost;
      --left;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < clocks.size(); ++i) {
      if (gone[i]) continue;
      if (kept != i) clocks[kept] = std::move(clocks[i]);
      ++kept;
    }
    clocks.resize(kept);
  }
  return changed;
}

}  // namespace rmpl::runtime
