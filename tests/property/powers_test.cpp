// Many steps at once beside one after the other in rational numbers.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/property/draw.hpp"
#include "tests/reference/probability.hpp"
#include "verifier/markov/sparse.hpp"

namespace rmpl::property {
namespace {

using reference::Rational;
using verifier::Enclosure;
using verifier::Real;
using verifier::SparseMatrix;

Rational exactly(Real value) {
  const auto high = static_cast<double>(value);
  return Rational(high) + Rational(static_cast<double>(value - static_cast<Real>(high)));
}

/// A chain in which each state is left with probabilities of 2^-`rarest` to 2^-`likeliest`; the last one never is.
void compare(std::size_t likeliest, std::size_t rarest, std::size_t most_steps) {
  const std::size_t size = up_to(2, 6);
  std::vector<SparseMatrix::SparseRow> rows(size);
  std::vector<std::vector<Rational>> exact(size, std::vector<Rational>(size));
  for (std::size_t r = 0; r < size; ++r) {
    Real stays = 1;
    for (std::size_t c = 0; c < size; ++c) {
      if (c == r || r + 1 == size || chance(50)) continue;
      const Real p = std::exp2(-static_cast<Real>(up_to(likeliest, rarest)));
      exact[r][c] = exactly(p);
      stays -= p;
    }
    exact[r][r] = exactly(stays);
    for (std::size_t c = 0; c < size; ++c) {
      if (exact[r][c] == 0) continue;
      const auto p = static_cast<Real>(exact[r][c]);
      rows[r].push_back({static_cast<std::uint32_t>(c), Enclosure{p, p}});
    }
  }
  std::vector<Enclosure> start(size);
  start.front() = verifier::certain();
  const std::size_t steps = up_to(0, most_steps);
  constexpr Real ignored = 1e-15L;
  const verifier::Limits limits;
  verifier::Meter meter(limits);
  const auto found = verifier::after_steps(start, SparseMatrix(rows), steps, ignored, meter);
  std::vector<Rational> at(size);
  at.front() = 1;
  for (std::size_t i = 0; i < steps; ++i) {
    std::vector<Rational> next(size);
    for (std::size_t r = 0; r < size; ++r) {
      for (std::size_t c = 0; c < size; ++c) next[c] += at[r] * exact[r][c];
    }
    at = std::move(next);
  }
  // What is left out may be missing everywhere, and is part of the last one.
  const Rational left_out = exactly(2 * ignored);
  for (std::size_t i = 0; i < size; ++i) {
    RC_ASSERT(exactly(found[i].lower) <= at[i]);
    RC_ASSERT(at[i] <= exactly(found[i].upper) + left_out);
    RC_ASSERT(exactly(found[i].upper) - exactly(found[i].lower) <= left_out + at[i] / 1'000'000'000);
  }
  RC_ASSERT(at.back() <= exactly(found.back().upper));
}

RC_GTEST_PROP(Powers, AreManySteps, ()) { compare(3, 8, 60); }

RC_GTEST_PROP(Powers, AreManyStepsWhereStatesAreSeldomLeft, ()) { compare(10, 20, 120); }

}  // namespace
}  // namespace rmpl::property
