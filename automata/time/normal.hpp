// Masses of a normal distribution on intervals, however far from its mean and however short.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "automata/time/time.hpp"

namespace rmpl::automata {

/// exp(x^2) erfc(x) for x >= 0: the scaled complementary error function, which does not underflow.
double scaled_erfc(double x);

/// The probability of an interval: mantissa * exp(-anchor^2 / 2), with the anchor in standard deviations from the mean.
struct NormalMass {
  double mantissa;
  std::optional<Ticks> anchor;  ///< the end that is nearer to the mean; none: that of an interval around the mean is 0
};

/// A normal distribution of times, parameters in seconds.
class StandardNormal {
 public:
  StandardNormal(double mean, double standard_deviation) : mean_(mean), deviation_(standard_deviation) {}

  /// from < to; `to` may be infinite.
  [[nodiscard]] NormalMass mass(Ticks from, Ticks to) const;
  /// ln of the scale of `a` by that of `b`: by how much more the exponent of `b` is.
  [[nodiscard]] double scale_between(const NormalMass& a, const NormalMass& b) const;

 private:
  /// In standard deviations from the mean.
  [[nodiscard]] double standardised(Ticks time) const;

  double mean_;
  double deviation_;
};

}  // namespace rmpl::automata
