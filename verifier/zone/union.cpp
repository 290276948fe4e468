// Unions of zones.
// SPDX-License-Identifier: MIT
#include "verifier/zone/union.hpp"

#include <algorithm>

namespace rmpl::verifier {

Zone hull(const Zone& a, const Zone& b) {
  std::vector<Units> matrix(a.matrix().begin(), a.matrix().end());
  // Canonical, as both are: a bound by way of a third clock is no less than either's own.
  std::transform(matrix.begin(), matrix.end(), b.matrix().begin(), matrix.begin(),
                 [](Units one, Units other) { return std::max(one, other); });
  return Zone::of_matrix(std::move(matrix), a.clocks());
}

bool disjoint(const Zone& a, const Zone& b) {
  const std::size_t n = a.clocks() + 1;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const Units one = a.bound(i, j);
      const Units other = b.bound(j, i);
      if (one != unbounded && other != unbounded && one + other < 0) return true;
    }
  }
  return false;
}

namespace {

class Cover {
 public:
  Cover(std::span<const Zone> parts, std::size_t pieces) : parts_(parts), pieces_(pieces) {}

  /// By the parts from there on.
  bool holds(Zone rest, std::size_t from) {
    for (; from < parts_.size(); ++from) {
      const Zone& part = parts_[from];
      if (disjoint(rest, part)) continue;
      if (pieces_ == 0) return false;
      --pieces_;
      if (!outside(rest, part, from + 1)) return false;
      return true;
    }
    return false;
  }

 private:
  /// Whether what is outside the part is covered by those that follow.
  bool outside(Zone& rest, const Zone& part, std::size_t next) {
    const std::size_t n = rest.clocks() + 1;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const Units bound = part.bound(i, j);
        if (bound >= rest.bound(i, j)) continue;
        Zone beyond = rest;
        if (beyond.constrain(j, i, -bound - 1) && !holds(std::move(beyond), next)) return false;
        if (!rest.constrain(i, j, bound)) return true;
      }
    }
    return true;
  }

  std::span<const Zone> parts_;
  std::size_t pieces_;
};

}  // namespace

bool within_union(const Zone& zone, std::span<const Zone> parts, std::size_t pieces) {
  return Cover(parts, pieces).holds(zone, 0);
}

}  // namespace rmpl::verifier
