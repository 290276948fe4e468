// Probabilities as people read them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rmpl::runtime {

/// A probability with three significant digits; `1` only where it is 1.
std::string three_digits(double probability);

}  // namespace rmpl::runtime
