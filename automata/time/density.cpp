// Distributions of transition times, by the masses of intervals.
//
// Everything is a ratio of masses to the right of the clock, never a difference of values of G: far out in a tail G is
// 1 to the last bit, and 1 - G is less than any double, long before the next step stops to matter. Masses are kept with
// the logarithm of their scale, lengths are subtracted as ticks.
// SPDX-License-Identifier: MIT
#include "automata/time/density.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "automata/time/cumulative_hazard.hpp"
#include "automata/time/firing.hpp"
#include "automata/time/normal.hpp"

namespace rmpl::automata {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of less than this parts are too little for a double.
constexpr double least_mass = 1e-200;

/// 1 - F(at) / F(upper), where what is below the upper bound is so little.
double rest_of_small(const Timing& timing, Ticks at) {
  return at > Ticks{} ? -std::expm1(log_ratio_of_small(timing.density, at, timing.upper)) : 1;
}

/// The probability of firing where all that is within the bounds is so little.
double fires_where_mass_is_small(const Timing& timing, Ticks from, Ticks to) {
  const double part = std::exp(log_ratio_of_small(timing.density, to, timing.upper));
  const double before = from > Ticks{} ? std::exp(log_ratio_of_small(timing.density, from, timing.upper)) : 0;
  return std::min((part - before) / rest_of_small(timing, from), 1.0);
}

/// The probability of firing while the clock goes from `from`, within the bounds, to `to`, before the upper one.
double fires(const Timing& timing, Ticks from, Ticks to) {
  const Density& density = timing.density;
  switch (density.kind) {
    case Density::Kind::uniform:
      return (to - from).seconds() / (timing.upper - from).seconds();
    case Density::Kind::exponential:
    case Density::Kind::weibull:
    case Density::Kind::erlang: {
      const double part = -std::expm1(-cumulative_hazard(density, from, to));
      if (timing.upper.is_infinite()) return part;
      const double all = -std::expm1(-cumulative_hazard(density, from, timing.upper));
      return all < least_mass ? fires_where_mass_is_small(timing, from, to) : part / all;
    }
    case Density::Kind::normal: {
      const StandardNormal normal(density.mean, density.standard_deviation);
      const NormalMass rest = normal.mass(from, timing.upper);
      const NormalMass part = normal.mass(from, to);
      return std::min(part.mantissa / rest.mantissa * std::exp(-normal.scale_between(rest, part)), 1.0);
    }
  }
  return 0;
}

/// -ln of the probability of not firing meanwhile: sums of what is positive; for steps that mostly fire.
double hazard(const Timing& timing, Ticks from, Ticks to) {
  const Density& density = timing.density;
  switch (density.kind) {
    case Density::Kind::uniform:
      return std::log((timing.upper - from).seconds() / (timing.upper - to).seconds());
    case Density::Kind::exponential:
    case Density::Kind::weibull:
    case Density::Kind::erlang: {
      const double step = cumulative_hazard(density, from, to);
      if (timing.upper.is_infinite()) return step;
      const double all = -std::expm1(-cumulative_hazard(density, from, timing.upper));
      if (all < least_mass) return std::log(rest_of_small(timing, from) / rest_of_small(timing, to));
      return step + std::log(all / -std::expm1(-cumulative_hazard(density, to, timing.upper)));
    }
    case Density::Kind::normal: {
      const StandardNormal normal(density.mean, density.standard_deviation);
      const NormalMass before = normal.mass(from, timing.upper);
      const NormalMass after = normal.mass(to, timing.upper);
      return std::log(before.mantissa / after.mantissa) + normal.scale_between(before, after);
    }
  }
  return 0;
}

/// Up to here the complement of a probability of firing is as good as the probability itself.
constexpr double seldom = 0.5;

}  // namespace

double Timing::survival(Ticks at) const { return step_survival(lower, at); }

double Timing::step_survival(Ticks from, Ticks to) const {
  if (const Firing bounds = firing(*this, from, to); bounds != Firing::possible)
    return bounds == Firing::certain ? 0 : 1;
  const double leaves = fires(*this, std::max(from, lower), to);
  return leaves < seldom ? 1 - leaves : std::exp(-hazard(*this, std::max(from, lower), to));
}

double Timing::step_hazard(Ticks from, Ticks to) const {
  if (const Firing bounds = firing(*this, from, to); bounds != Firing::possible) {
    return bounds == Firing::certain ? infinity : 0;
  }
  const double leaves = fires(*this, std::max(from, lower), to);
  return leaves < seldom ? -std::log1p(-leaves) : hazard(*this, std::max(from, lower), to);
}

}  // namespace rmpl::automata
