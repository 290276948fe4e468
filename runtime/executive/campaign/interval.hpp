// The confidence interval of a counted share.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace rmpl::runtime {

/// Of a probability, from how often something happened in so many independent trials.
struct Interval {
  double low = 0;
  double high = 1;
};

/// The interval of Clopper and Pearson (Biometrika 26, 1934): it holds the probability in at least 95 % of all cases,
/// whatever the probability is. `count` is at most `trials`; of no trials it is from 0 to 1.
Interval clopper_pearson(std::uint64_t count, std::uint64_t trials);

}  // namespace rmpl::runtime
