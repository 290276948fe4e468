// Cumulative hazards.
//
// Exponential: x. Weibull with shape k: x^k. Erlang with n stages, x being the time in units of a stage:
//   1 - F = exp(-x) P(x),  P(x) = sum of x^i / i! for i < n  (NIST Handbook of Mathematical Functions, 8.4.10),
// so that the hazard from a to b is (b - a) - ln(P(b) / P(a)); where that would cancel, it is taken from the mass of
// the interval, by the series of 8.7.1 where most of the mass below b lies in the interval, else by the quadrature of
// Gauss and Legendre over a stretch in which the density is smooth. Lengths come from ticks, so that a nanosecond keeps
// all its digits at the end of a year. SPDX-License-Identifier: MIT
#include "automata/time/cumulative_hazard.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "base/check.hpp"

namespace rmpl::automata {
namespace {

/// Nothing is left beyond it, and sums of such hazards are numbers still.
constexpr double greatest_hazard = 1e200;

/// x^k grows by this from a to a + w.
double weibull(double shape, double a, double w) {
  const double before = std::pow(a, shape);
  const double grown = w > a ? std::pow(a + w, shape) - before : before * std::expm1(shape * std::log1p(w / a));
  // Where powers are beyond all doubles, so is what they differ by.
  return grown < greatest_hazard ? grown : greatest_hazard;
}

/// Abscissas and weights on [-1, 1]; the other eight are their mirror images.
constexpr std::array<std::pair<double, double>, 8> gauss_legendre_16{{{0.0950125098376374402, 0.1894506104550684963},
                                                                      {0.2816035507792589132, 0.1826034150449235889},
                                                                      {0.4580167776572273863, 0.1691565193950025382},
                                                                      {0.6178762444026437484, 0.1495959888165767321},
                                                                      {0.7554044083550030339, 0.1246289712555338720},
                                                                      {0.8656312023878317439, 0.0951585116824927848},
                                                                      {0.9445750230732325761, 0.0622535239386478929},
                                                                      {0.9894009349916499326, 0.0271524594117540949}}};

/// Times are in units of a stage.
class Erlang {
 public:
  explicit Erlang(double stages) : stages_(stages) {}

  /// From a to a + w.
  [[nodiscard]] double hazard(double a, double w) const {
    constexpr double cancels = 0.5;
    const double difference = w - log_ratio(a, w);
    if (difference > cancels) return difference;
    return -std::log1p(-share(a, w));
  }

  /// The mass below x by exp(-x) x^n / n!.
  [[nodiscard]] double series(double x) const {
    double term = 1, sum = 1;
    for (double i = stages_ + 1; term > sum * 1e-18; ++i) sum += term *= x / i;
    return sum;
  }
  /// The mass from y - w to y by that below y, where that is little.
  [[nodiscard]] double last_share(double y, double w) const {
    return integral(w, [&](double u) { return std::exp((stages_ - 1) * std::log1p(-u / y) + u); }) * stages_ /
           (y * series(y));
  }
  /// ln of the mass below x.
  [[nodiscard]] double log_below(double x) const {
    return stages_ * std::log(x) - x - std::lgamma(stages_ + 1) + std::log(series(x));
  }

 private:
  static constexpr double far = 500;  ///< from here on P(x) is taken relative to its last term

  /// P(x).
  [[nodiscard]] double sum(double x) const {
    double term = 1, sum = 1;
    for (double i = 1; i < stages_; ++i) sum += term *= x / i;
    return sum;
  }
  /// P(x) by its last term.
  [[nodiscard]] double sum_by_last(double x) const {
    double term = 1, sum = 1;
    for (double i = 1; i < stages_; ++i) sum += term *= (stages_ - i) / x;
    return sum;
  }

  /// ln(P(a + w) / P(a)).
  [[nodiscard]] double log_ratio(double a, double w) const {
    const double b = a + w;
    if (a > far) return (stages_ - 1) * std::log1p(w / a) + std::log(sum_by_last(b) / sum_by_last(a));
    if (b <= far) return std::log(sum(b) / sum(a));
    return (stages_ - 1) * std::log(b) - std::lgamma(stages_) + std::log(sum_by_last(b)) - std::log(sum(a));
  }

  /// The mass from a to a + w by that from a on.
  [[nodiscard]] double share(double a, double w) const {
    if (a > far) {
      return integral(w, [&](double u) { return std::exp((stages_ - 1) * std::log1p(u / a) - u); }) / sum_by_last(a);
    }
    const double rest = std::exp(-a) * sum(a);
    const double below_b = std::exp(log_below(a + w));
    const double below_a = a > 0 ? std::exp(log_below(a)) : 0;
    if (below_a <= below_b / 2) return (below_b - below_a) / rest;
    const double scale = std::lgamma(stages_);
    return integral(w, [&](double u) { return std::exp((stages_ - 1) * std::log(a + u) - (a + u) - scale); }) / rest;
  }

  template <class Function>
  static double integral(double w, const Function& function) {
    double sum = 0;
    for (const auto& [abscissa, weight] : gauss_legendre_16) {
      sum += weight * (function(w / 2 * (1 - abscissa)) + function(w / 2 * (1 + abscissa)));
    }
    return w / 2 * sum;
  }

  double stages_;
};

}  // namespace

double cumulative_hazard(const Density& density, Ticks from, Ticks to) {
  const double length = (to - from).seconds();
  switch (density.kind) {
    case Density::Kind::uniform:
    case Density::Kind::normal:
      break;
    case Density::Kind::exponential:
      return length / density.mean;
    case Density::Kind::weibull:
      return weibull(density.shape, from.seconds() / density.scale, length / density.scale);
    case Density::Kind::erlang: {
      const double stage = density.mean / density.shape;
      return Erlang(density.shape).hazard(from.seconds() / stage, length / stage);
    }
  }
  CHECK(false && "a density whose hazard is known");
  return 0;
}

double log_ratio_of_small(const Density& density, Ticks at, Ticks later) {
  const double log_of_times = std::log1p(-(later - at).seconds() / later.seconds());
  switch (density.kind) {
    case Density::Kind::uniform:
    case Density::Kind::normal:
      break;
    case Density::Kind::exponential:
      return log_of_times;
    case Density::Kind::weibull:
      return density.shape * log_of_times;
    case Density::Kind::erlang: {
      const double stage = density.mean / density.shape;
      const double y = later.seconds() / stage, w = (later - at).seconds() / stage;
      const Erlang erlang(density.shape);
      // A difference would have no digits left.
      if (density.shape * w < y) return std::log1p(-erlang.last_share(y, w));
      return density.shape * log_of_times + w + std::log(erlang.series(at.seconds() / stage) / erlang.series(y));
    }
  }
  CHECK(false && "a density whose hazard is known");
  return 0;
}

}  // namespace rmpl::automata
