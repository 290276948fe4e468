// Masses of a normal distribution.
//
// Away from the mean, with a the end that is nearer to it and w the length, both in standard deviations,
//   mass = exp(-a^2/2) / sqrt(2 pi) * integral of exp(-(a x + x^2/2)) for x from 0 to w,
// and the integral is a difference of two scaled complementary error functions, which loses nothing where the exponent
// grows beyond 1, and elsewhere is smooth enough for eight points of Gauss and Legendre. Lengths come from ticks, so
// that a nanosecond keeps all its digits at the end of a year.
// SPDX-License-Identifier: MIT
#include "automata/time/normal.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace rmpl::automata {
namespace {

constexpr double sqrt_half = 0.70710678118654752440;
constexpr double density_at_mean = 0.39894228040143267794;  ///< 1 / sqrt(2 pi)

/// Abscissas and weights on [-1, 1]; the other four are their mirror images.
constexpr std::array<std::pair<double, double>, 4> gauss_legendre_8{{{0.1834346424956498049, 0.3626837833783619830},
                                                                     {0.5255324099163289858, 0.3137066458778872873},
                                                                     {0.7966664774136267396, 0.2223810344533744705},
                                                                     {0.9602898564975362317, 0.1012285362903762592}}};

/// The mantissa of the mass from a >= 0 standard deviations on, over a length of w > 0 of them.
double mantissa(double a, double w) {
  const double exponent = w * (a + w / 2);
  if (exponent > 1) {
    const double rest = std::exp(-exponent);
    return (scaled_erfc(a * sqrt_half) - (rest > 0 ? rest * scaled_erfc((a + w) * sqrt_half) : 0)) / 2;
  }
  double sum = 0;
  for (const auto& [abscissa, weight] : gauss_legendre_8) {
    for (const double x : {w / 2 * (1 - abscissa), w / 2 * (1 + abscissa)}) sum += weight * std::exp(-x * (a + x / 2));
  }
  return density_at_mean * w / 2 * sum;
}

}  // namespace

double scaled_erfc(double x) {
  if (x < 5) {
    const double square = x * x;
    const double rounding = std::fma(x, x, -square);
    return std::exp(square) * (1 + rounding) * std::erfc(x);
  }
  // The continued fraction of Laplace; so many levels are enough from 5 on.
  constexpr int levels = 20;
  double tail = x;
  for (int level = levels; level > 0; --level) tail = x + level / (2 * tail);
  return std::numbers::inv_sqrtpi / tail;
}

/// The difference is taken exactly but for one rounding: whole seconds as ticks, the rest of the mean in one fma.
double StandardNormal::standardised(Ticks time) const {
  constexpr auto per_second = static_cast<double>(Ticks::per_second);
  if (std::abs(mean_) > 9e9) return (time.seconds() - mean_) / deviation_;  // the mean is beyond all ticks
  const double whole = std::floor(mean_);
  const Ticks difference = time - Ticks::of_seconds(static_cast<std::int64_t>(whole));
  return std::fma(whole - mean_, per_second, static_cast<double>(difference.count)) / (deviation_ * per_second);
}

NormalMass StandardNormal::mass(Ticks from, Ticks to) const {
  const double a = standardised(from);
  const double b = to.is_infinite() ? INFINITY : standardised(to);
  const double w = (to - from).seconds() / deviation_;
  const double length = to.is_infinite() ? INFINITY : w;
  if (a >= 0) return {mantissa(a, length), from};
  if (b <= 0) return {mantissa(-b, length), to};
  return {(std::erf(b * sqrt_half) + std::erf(-a * sqrt_half)) / 2, std::nullopt};
}

double StandardNormal::scale_between(const NormalMass& a, const NormalMass& b) const {
  if (a.anchor && b.anchor) {
    return (*b.anchor - *a.anchor).seconds() / deviation_ * (standardised(*a.anchor) + standardised(*b.anchor)) / 2;
  }
  const auto exponent = [this](const NormalMass& mass) {
    return mass.anchor ? standardised(*mass.anchor) * standardised(*mass.anchor) / 2 : 0;
  };
  return exponent(b) - exponent(a);
}

}  // namespace rmpl::automata
