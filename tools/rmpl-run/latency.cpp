// Quantiles of durations.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/latency.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace rmpl::tools {

void Latency::add(double seconds) {
  const double octave = std::log2(std::max(1.0, 1e9 * seconds));
  const auto bucket = static_cast<std::size_t>(octave * buckets_per_octave);
  ++buckets_[std::min(bucket, buckets_.size() - 1)];
  ++count_;
  worst_ = std::max(worst_, seconds);
}

double Latency::quantile(double share) const {
  const auto rank = static_cast<std::uint64_t>(share * static_cast<double>(count_));
  std::uint64_t below = 0;
  for (std::size_t b = 0; b < buckets_.size(); ++b) {
    below += buckets_[b];
    if (below > rank) return std::min(worst_, 1e-9 * std::exp2((static_cast<double>(b) + 0.5) / buckets_per_octave));
  }
  return worst_;
}

std::string Latency::text() const {
  if (count_ == 0) return {};
  std::ostringstream out;
  out << std::setprecision(3) << 1e3 * quantile(0.5) << " ms median, " << 1e3 * quantile(0.99)
      << " ms 99th percentile, " << 1e3 * worst_ << " ms worst";
  return out.str();
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace rmpl::tools
