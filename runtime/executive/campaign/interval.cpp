// The exact interval, as quantiles of the beta distribution.
// SPDX-License-Identifier: MIT
#include "runtime/executive/campaign/interval.hpp"

#include <boost/math/special_functions/beta.hpp>

namespace rmpl::runtime {

namespace {

/// Doubles do; and valgrind, which has no longer ones, can run the programs.
using InDoubles = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

}  // namespace

Interval clopper_pearson(std::uint64_t count, std::uint64_t trials) {
  constexpr double tail = 0.025;
  const auto k = static_cast<double>(count);
  const auto n = static_cast<double>(trials);
  Interval interval;
  if (count > 0) interval.low = boost::math::ibeta_inv(k, n - k + 1, tail, InDoubles());
  if (count < trials) interval.high = boost::math::ibetac_inv(k + 1, n - k, tail, InDoubles());
  return interval;
}

}  // namespace rmpl::runtime
