// A source of random numbers whose bytes depend on the seed alone: the same on every machine and standard library.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rmpl::runtime {

/// SplitMix64 (Steele, Lea, Flood 2014): 64 bits of state, period 2^64, every seed is good.
class RandomSource {
 public:
  /// `stream` keeps sources with one seed apart, so that drawing more from one does not change the other.
  explicit RandomSource(std::uint64_t seed, std::uint64_t stream = 0);

  std::uint64_t next();
  /// In [0, 1): the upper 53 bits, times 2^-53.
  double uniform();
  /// A position below `count`, each as likely as the others (to within count * 2^-53); `count` is above 0.
  std::size_t below(std::size_t count);

 private:
  std::uint64_t state_;
};

/// A position below `count`, which is above 0, by a number in [0, 1).
std::size_t position_below(std::size_t count, double at);

/// One of some weighed things, at least one, by a number in [0, 1); weights need not sum to 1. The last where rounding
/// leaves nothing.
template <class Weighed>
const Weighed& drawn(const std::vector<Weighed>& from, double at) {
  double total = 0;
  for (const Weighed& one : from) total += one.probability;
  double left = at * total;
  for (const Weighed& one : from) {
    left -= one.probability;
    if (left < 0) return one;
  }
  return from.back();
}

}  // namespace rmpl::runtime
