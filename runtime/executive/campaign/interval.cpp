// The exact interval, as quantiles of the beta distribution.
// SPDX-License-Identifier: MIT
#include "runtime/executive/campaign/interval.hpp"

#include <boost/math/special_functions/beta.hpp>

namespace rmpl::runtime {

Interval clopper_pearson(std::uint64_t count, std::uint64_t trials) {
  constexpr double tail = 0.025;
  const auto k = static_cast<double>(count);
  const auto n = static_cast<double>(trials);
  Interval interval;
  if (count > 0) interval.low = boost::math::ibeta_inv(k, n - k + 1, tail);
  if (count < trials) interval.high = boost::math::ibetac_inv(k + 1, n - k, tail);
  return interval;
}

}  // namespace rmpl::runtime
