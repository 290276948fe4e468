// Numbers from 0 that are known to lie between two bounds.
//
// All sums here have terms from 0 only, so that rounding moves a result by a small part of itself: the bounds are moved
// outward by more than that. Real has more digits than the double precision of probabilities where the machine has
// them, and a greater range: what a double cannot hold is still above 0 here. SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

namespace rmpl::verifier {

using Real = long double;

/// lower <= the number <= upper, both at least 0.
struct Enclosure {
  Real lower = 0;
  Real upper = 0;
  bool operator==(const Enclosure&) const = default;
};

namespace rounding {
/// A lower bound below it is 0, an upper bound above 0 is at least it: far enough from where numbers lose digits.
inline constexpr Real least = std::numeric_limits<Real>::min() * 0x1p80L;
/// More than the relative error of one operation.
inline constexpr Real unit = std::numeric_limits<Real>::epsilon();

inline Real down(Real value, std::size_t operations) {
  const Real result = value * (1 - unit * static_cast<Real>(operations + 1));
  return result < least ? 0 : result;
}
inline Real up(Real value, std::size_t operations) {
  if (value == 0) return 0;
  return std::max(value * (1 + unit * static_cast<Real>(operations + 1)), least);
}
}  // namespace rounding

/// Enclosure moved outward by the relative error of so many operations.
inline Enclosure outward(const Enclosure& value, std::size_t operations) {
  return {rounding::down(value.lower, operations), rounding::up(value.upper, operations)};
}

inline Enclosure certain() { return {1, 1}; }
inline bool is_certain(const Enclosure& value) { return value.lower == 1 && value.upper == 1; }

inline Enclosure operator*(const Enclosure& a, const Enclosure& b) {
  if (is_certain(a)) return b;
  if (is_certain(b)) return a;
  Enclosure result = outward({a.lower * b.lower, a.upper * b.upper}, 1);
  // Two upper bounds above 0 may have a product of 0.
  if (a.upper > 0 && b.upper > 0) result.upper = std::max(result.upper, rounding::least);
  return result;
}

inline Enclosure operator+(const Enclosure& a, const Enclosure& b) {
  if (a.upper == 0) return b;
  if (b.upper == 0) return a;
  return outward({a.lower + b.lower, a.upper + b.upper}, 1);
}

/// `b` is above 0.
inline Enclosure operator/(const Enclosure& a, const Enclosure& b) {
  if (is_certain(b)) return a;
  return outward({a.lower / b.upper, b.lower > 0 ? a.upper / b.lower : std::numeric_limits<Real>::infinity()}, 1);
}

/// A probability is at most 1.
inline Enclosure as_probability(const Enclosure& value) {
  return {std::min<Real>(value.lower, 1), std::min<Real>(value.upper, 1)};
}

/// Whether the bounds are as near to each other as the part of the upper one says.
inline bool is_within(const Enclosure& value, Real precision) {
  return value.upper - value.lower <= precision * value.upper;
}

}  // namespace rmpl::verifier
