// How long cycles took, in bounded memory: a histogram whose buckets grow with the time.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string>

namespace rmpl::tools {

/// Durations, by quantile. Buckets are a sixty-fourth of an octave wide: a quantile is right to 1.1 %, the worst
/// exactly.
class Latency {
 public:
  void add(double seconds);
  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// `0.21 ms median, 0.8 ms 99th percentile, 2.1 ms worst`; of none: nothing.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] double quantile(double share) const;

  static constexpr int buckets_per_octave = 64;
  static constexpr int octaves = 40;  ///< from 1 ns on
  std::array<std::uint64_t, static_cast<std::size_t>(buckets_per_octave* octaves)> buckets_{};
  std::uint64_t count_ = 0;
  double worst_ = 0;
};

/// Since `start`, by the steady clock.
double seconds_since(std::chrono::steady_clock::time_point start);

}  // namespace rmpl::tools
