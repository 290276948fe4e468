// Distributions of transition times, by their survival functions.
//
// Everything is computed as a ratio of tails, 1 - G, never as a difference of values of G: far out in the tail of a
// normal density G is 1 to the last bit long before the probability of the next step stops to matter.
// SPDX-License-Identifier: MIT
#include "automata/time/density.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rmpl::automata {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The probability that an untruncated draw falls between `from` and `to` seconds.
double mass(const Density& density, double from, double to) {
  switch (density.kind) {
    case Density::Kind::uniform:
      return to - from;
    case Density::Kind::exponential:
      // Relative to the tail at `from`, which all ratios have in common: exp never underflows for long waits.
      return -std::expm1(-(to - from) / density.mean);
    case Density::Kind::normal: {
      const double scale = density.standard_deviation * std::sqrt(2.0);
      const double a = (from - density.mean) / scale;
      const double b = (to - density.mean) / scale;
      // Subtract on the side where the tails are small.
      return a > 0 ? 0.5 * (std::erfc(a) - std::erfc(b)) : 0.5 * (std::erfc(-b) - std::erfc(-a));
    }
  }
  return 0;
}

}  // namespace

double Timing::survival(Ticks at) const {
  if (at >= upper) return 0;
  if (at <= lower) return 1;
  const double l = lower.seconds();
  const double u = upper.seconds();
  const double t = at.seconds();
  const double whole = mass(density, l, u);
  if (!(whole > 0)) return 0;  // the density has no weight between the bounds: it fires at the lower bound
  double rest = mass(density, t, u);
  if (density.kind == Density::Kind::exponential) rest *= std::exp(-(t - l) / density.mean);
  return std::clamp(rest / whole, 0.0, 1.0);
}

double Timing::step_survival(Ticks from, Ticks to) const {
  if (to >= upper) return 0;
  const double before = survival(from);
  if (before <= 0) return 0;
  return std::clamp(survival(to) / before, 0.0, 1.0);
}

double Timing::step_hazard(Ticks from, Ticks to) const {
  if (to <= lower || to <= from) return survival(from) > 0 && to < upper ? 0 : infinity;
  const double left = step_survival(from, to);
  if (left <= 0) return infinity;
  return -std::log(left);
}

}  // namespace rmpl::automata
