// Zones as difference bound matrices.
// SPDX-License-Identifier: MIT
#include "verifier/zone/zone.hpp"

#include <algorithm>
#include <functional>

#include "base/check.hpp"

namespace rmpl::verifier {
namespace {

/// The bound of a path. Finite bounds are far from the ends of the range (Reading sees to it), so that sums do not
/// overflow.
Units sum(Units a, Units b) { return a == unbounded || b == unbounded ? unbounded : a + b; }

}  // namespace

Zone::Zone(std::size_t clocks) : dimension_(clocks + 1), bounds_(dimension_ * dimension_, 0) {}

bool Zone::constrain(std::size_t i, std::size_t j, Units b) {
  if (b >= bound(i, j)) return true;
  if (sum(bound(j, i), b) < 0) return false;
  at(i, j) = b;
  // What is tighter now goes through the new bound: k to i, i to j, j to l.
  for (std::size_t k = 0; k < dimension_; ++k) {
    const Units through = sum(bound(k, i), b);
    if (through >= bound(k, j) && k != i) continue;
    for (std::size_t l = 0; l < dimension_; ++l) at(k, l) = std::min(bound(k, l), sum(through, bound(j, l)));
  }
  return true;
}

bool Zone::constrain(std::size_t clock, const Interval& interval) {
  CHECK(interval.lower != unbounded);
  return constrain(0, clock, -interval.lower) && constrain(clock, 0, interval.upper);
}

void Zone::elapse() {
  for (std::size_t i = 1; i < dimension_; ++i) at(i, 0) = unbounded;
}

void Zone::tick() {
  for (std::size_t i = 1; i < dimension_; ++i) {
    at(i, 0) = sum(bound(i, 0), 1);
    at(0, i) -= 1;
  }
}

Zone Zone::select(std::span<const std::size_t> sources) const {
  Zone result(sources.size());
  const auto source = [&](std::size_t clock) { return clock == 0 ? 0 : sources[clock - 1]; };
  for (std::size_t i = 0; i < result.dimension_; ++i) {
    for (std::size_t j = 0; j < result.dimension_; ++j) result.at(i, j) = bound(source(i), source(j));
  }
  return result;
}

void Zone::extrapolate(std::span<const ClockLimits> limits) {
  CHECK(limits.size() == clocks());
  const auto limit = [&](std::size_t clock) { return clock == 0 ? ClockLimits{0, 0} : limits[clock - 1]; };
  const std::vector<Units> exact = bounds_;
  const auto lower = [&](std::size_t clock) { return -exact[clock]; };
  bool widened = false;
  for (std::size_t i = 0; i < dimension_; ++i) {
    for (std::size_t j = 0; j < dimension_; ++j) {
      if (i == j) continue;
      Units wide = bound(i, j);
      if (i == 0) {
        if (lower(j) > limit(j).upper) wide = -(limit(j).upper + 1);
      } else if (wide > limit(i).lower || lower(i) > limit(i).lower || lower(j) > limit(j).upper) {
        wide = unbounded;
      }
      widened = widened || wide != bound(i, j);
      at(i, j) = wide;
    }
  }
  if (widened) close();
}

void Zone::close() {
  for (std::size_t k = 0; k < dimension_; ++k) {
    for (std::size_t i = 0; i < dimension_; ++i) {
      const Units first = bound(i, k);
      if (first == unbounded) continue;
      for (std::size_t j = 0; j < dimension_; ++j) at(i, j) = std::min(bound(i, j), sum(first, bound(k, j)));
    }
  }
}

bool Zone::includes(const Zone& other) const {
  CHECK(dimension_ == other.dimension_);
  return std::equal(bounds_.begin(), bounds_.end(), other.bounds_.begin(), std::greater_equal<>{});
}

Zone Zone::of_matrix(std::vector<Units> matrix, std::size_t clocks) {
  CHECK(matrix.size() == (clocks + 1) * (clocks + 1));
  Zone result(0);
  result.dimension_ = clocks + 1;
  result.bounds_ = std::move(matrix);
  return result;
}

bool Zone::contains(std::span<const Units> reading) const {
  CHECK(reading.size() == clocks());
  const auto value = [&](std::size_t clock) { return clock == 0 ? 0 : reading[clock - 1]; };
  for (std::size_t i = 0; i < dimension_; ++i) {
    for (std::size_t j = 0; j < dimension_; ++j) {
      if (value(i) - value(j) > bound(i, j)) return false;
    }
  }
  return true;
}

}  // namespace rmpl::verifier
