// When one zone covers another: up to what the bounds that clocks are compared with can tell apart.
//
// A reading v' simulates v if for every clock v'(x) = v(x), or L(x) < v'(x) < v(x), or U(x) < v(x) < v'(x): then it can
// do all that v can (L and U being the greatest constants in lower and upper bounds on x). All readings that some
// reading of a zone simulates are its abstraction, the coarsest that is sound for all automata with these bounds. It is
// not convex, and need never be built: whether it holds another zone is seen two clocks at a time.
// F. Herbreteau, B. Srivathsan, I. Walukiewicz: Better Abstractions for Timed Automata, LICS 2012, Theorem 34. As all
// bounds here are weak and whole, "<" on readings is decided on whole numbers, and serves sampled time as well.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "verifier/zone/zone.hpp"

namespace rmpl::verifier {

/// Whether `larger`, up to the limits (one a clock), covers `smaller`. Both are canonical matrices of dimension n,
/// row by row; `Entry` is any signed integer, whose greatest value stands for no bound. O(n^2).
template <class Larger, class Smaller>
bool covers(const Larger* larger, const Smaller* smaller, std::size_t n, std::span<const ClockLimits> limits) {
  constexpr Larger no_bound = std::numeric_limits<Larger>::max();
  constexpr Smaller no_bound_smaller = std::numeric_limits<Smaller>::max();
  for (std::size_t x = 0; x < n; ++x) {
    const Units lower = x == 0 ? 0 : -Units{smaller[x]};
    if (x != 0 && lower > limits[x - 1].upper) continue;
    for (std::size_t y = 0; y < n; ++y) {
      const Larger wide = larger[y * n + x];
      const Smaller narrow = smaller[y * n + x];
      if (wide == no_bound || (narrow != no_bound_smaller && Units{wide} >= Units{narrow})) continue;
      if (Units{wide} + lower <= (y == 0 ? 0 : limits[y - 1].lower)) return false;
    }
  }
  return true;
}

/// Whether every reading of `smaller` is one of `larger`.
template <class Larger, class Smaller>
bool includes(const Larger* larger, const Smaller* smaller, std::size_t n) {
  constexpr Larger no_bound = std::numeric_limits<Larger>::max();
  constexpr Smaller no_bound_smaller = std::numeric_limits<Smaller>::max();
  for (std::size_t i = 0; i < n * n; ++i) {
    if (larger[i] == no_bound) continue;
    if (smaller[i] == no_bound_smaller || Units{larger[i]} < Units{smaller[i]}) return false;
  }
  return true;
}

}  // namespace rmpl::verifier
