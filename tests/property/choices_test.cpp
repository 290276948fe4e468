// Decision processes without end beside all of their policies in rational numbers.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/property/draw.hpp"
#include "tests/reference/policies.hpp"
#include "verifier/markov/unbounded.hpp"

namespace rmpl::property {
namespace {

using reference::Rational;
using reference::RationalProcess;
using verifier::Aim;
using verifier::Enclosure;

constexpr verifier::Real precision = 1e-6L;

struct Both {
  RationalProcess exact;
  verifier::DecisionProcess bounds;
};

/// Binary fractions, down to 2^-exponent, which both hold exactly: what is rare makes for long runs.
Both drawn(unsigned exponent) {
  const std::size_t size = up_to(2, 5);
  Both result;
  result.exact.wanted.assign(size, false);
  result.exact.wanted.back() = true;
  result.exact.choices.resize(size);
  for (std::size_t s = 0; s + 1 < size; ++s) {
    const std::size_t choices = up_to(chance(10) ? 0 : 1, 3);
    for (std::size_t c = 0; c < choices; ++c) {
      std::vector<std::size_t> to{up_to(0, size - 1), up_to(0, size - 1), up_to(0, size - 1)};
      std::sort(to.begin(), to.end());
      to.erase(std::unique(to.begin(), to.end()), to.end());
      RationalProcess::Choice choice;
      Rational left = 1;
      for (std::size_t i = 0; i + 1 < to.size(); ++i) {
        const Rational part(1, boost::multiprecision::cpp_int(1) << up_to(2, exponent));
        choice.emplace_back(to[i], part);
        left -= part;
      }
      choice.emplace_back(to.back(), left);
      result.exact.choices[s].push_back(choice);
    }
  }
  result.bounds.wanted = result.exact.wanted;
  result.bounds.start.push_back({{0, 0}, verifier::certain()});
  for (const auto& choices : result.exact.choices) {
    auto& rows = result.bounds.rows.emplace_back();
    for (const auto& choice : choices) {
      verifier::Row& row = rows.emplace_back();
      for (const auto& [to, probability] : choice) {
        const auto p = static_cast<verifier::Real>(probability);
        row.edges.push_back({static_cast<verifier::StateNumber>(to), {p, p}, 0});
      }
    }
  }
  return result;
}

Rational rational(verifier::Real value) {
  int exponent = 0;
  const auto digits = std::ldexp(std::frexp(value, &exponent), 64);
  const Rational whole(static_cast<std::uint64_t>(digits));
  const boost::multiprecision::cpp_int one = 1;
  return exponent >= 64 ? Rational(whole * Rational(one << (exponent - 64)))
                        : Rational(whole / Rational(one << (64 - exponent)));
}

void check(const Enclosure& found, const Rational& exact) {
  RC_ASSERT(rational(found.lower) <= exact);
  RC_ASSERT(exact <= rational(found.upper));
  RC_ASSERT(is_within(found, precision));
}

void check_mean(const Enclosure& found, const std::optional<Rational>& exact) {
  RC_ASSERT((found.lower == verifier::unbounded_time) == !exact.has_value());
  if (exact) check(found, *exact);
}

void check_means(const Both& both) {
  const verifier::Limits limits;
  verifier::Meter meter(limits);
  const reference::MeanSteps exact = reference::mean_steps(both.exact, 0);
  check_mean(verifier::mean_steps(both.bounds, Aim::least, meter), exact.least);
  check_mean(verifier::mean_steps(both.bounds, Aim::greatest, meter), exact.greatest);
}

void check_ever(const Both& both) {
  const verifier::Limits limits;
  verifier::Meter meter(limits);
  const reference::Probabilities exact = reference::ever(both.exact, 0);
  check(verifier::ever(both.bounds, Aim::least, meter), exact.least);
  check(verifier::ever(both.bounds, Aim::greatest, meter), exact.greatest);
}

RC_GTEST_PROP(Choices, HaveTheirMeanTime, ()) { check_means(drawn(4)); }

RC_GTEST_PROP(Choices, HaveTheirMeanTimeWhereItIsLong, ()) { check_means(drawn(9)); }

RC_GTEST_PROP(Choices, HaveTheirProbability, ()) { check_ever(drawn(4)); }

RC_GTEST_PROP(Choices, HaveTheirProbabilityWhereRunsAreLong, ()) { check_ever(drawn(9)); }

}  // namespace
}  // namespace rmpl::property
