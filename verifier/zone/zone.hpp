// Zones: convex sets of clock readings, as difference bound matrices.
//
// Entry (i, j) is the least b with x_i - x_j <= b; x_0 stands for 0. All bounds are weak and whole, so that one matrix
// serves dense and sampled time: a non-empty zone has integer points, and its bounds are attained in them. The matrix
// is kept canonical (no entry can be tightened without losing a point) by every operation.
// J. Bengtsson and W. Yi, Timed Automata: Semantics, Algorithms and Tools, 2004.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "verifier/zone/interval.hpp"

namespace rmpl::verifier {

/// The greatest constants that a clock is compared with: from below (`lower`: x >= c) and from above (`upper`: x <= c);
/// -1 where it never is.
struct ClockLimits {
  Units lower = -1;
  Units upper = -1;
  bool operator==(const ClockLimits&) const = default;
};

/// A non-empty set of readings of the clocks 1 … n. An operation that returns false has found that nothing is left; the
/// zone is then not to be used any more.
class Zone {
 public:
  /// All clocks are 0.
  explicit Zone(std::size_t clocks);

  [[nodiscard]] std::size_t clocks() const { return dimension_ - 1; }
  /// The greatest x_i - x_j, or `unbounded`.
  [[nodiscard]] Units bound(std::size_t i, std::size_t j) const { return bounds_[i * dimension_ + j]; }
  [[nodiscard]] Units lower(std::size_t clock) const { return -bound(0, clock); }
  [[nodiscard]] Units upper(std::size_t clock) const { return bound(clock, 0); }
  /// Whether the clock reads something within the interval at some reading. O(1).
  [[nodiscard]] bool meets(std::size_t clock, const Interval& interval) const {
    return upper(clock) >= interval.lower && lower(clock) <= interval.upper;
  }
  [[nodiscard]] std::size_t bytes() const { return sizeof(*this) + bounds_.capacity() * sizeof(Units); }

  /// Keeps the readings with x_i - x_j <= b. O(n^2).
  [[nodiscard]] bool constrain(std::size_t i, std::size_t j, Units b);
  /// Keeps the readings in which the clock is within the interval.
  [[nodiscard]] bool constrain(std::size_t clock, const Interval& interval);

  /// Any time passes: every later reading joins. O(n).
  void elapse();
  /// Exactly one unit of time passes. O(n).
  void tick();

  /// The zone over new clocks 1 … m in which clock k reads as clock sources[k - 1] did; source 0 is a clock that starts
  /// now. O(m^2).
  [[nodiscard]] Zone select(std::span<const std::size_t> sources) const;

  /// Adds readings that can be told apart from those in the zone by no comparison within the limits (one entry a
  /// clock), so that finitely many zones are left. G. Behrmann, P. Bouyer, K. Larsen, R. Pelanek, Lower and Upper
  /// Bounds in Zone-Based Abstractions of Timed Automata, STTT 2006: Extra+LU, where "x > U" is x >= U + 1 as all
  /// bounds are whole. O(n^3).
  void extrapolate(std::span<const ClockLimits> limits);

  /// Whether every reading of the other zone, over the same clocks, is in this one. O(n^2).
  [[nodiscard]] bool includes(const Zone& other) const;
  /// The matrix, row by row; row and column 0 are those of the constant 0.
  [[nodiscard]] std::span<const Units> matrix() const { return bounds_; }
  /// The zone of such a matrix, which is canonical.
  static Zone of_matrix(std::vector<Units> matrix, std::size_t clocks);
  /// Whether a reading (clock 1 first) is in the zone.
  [[nodiscard]] bool contains(std::span<const Units> reading) const;

  bool operator==(const Zone&) const = default;

 private:
  Units& at(std::size_t i, std::size_t j) { return bounds_[i * dimension_ + j]; }
  void close();

  std::size_t dimension_;
  std::vector<Units> bounds_;  ///< row by row
};

}  // namespace rmpl::verifier
