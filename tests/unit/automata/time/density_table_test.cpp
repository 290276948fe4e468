// Densities against decimal arithmetic (density_table.py): steps from a nanosecond on, up to a million means out.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "automata/time/density.hpp"
#include "automata/time/firing.hpp"
#include "automata/time/normal.hpp"

namespace rmpl::automata {
namespace {

constexpr std::int64_t endless = Ticks::infinite().count;

struct Row {
  Density::Kind kind;
  double mean, deviation;  ///< of weibull: shape, scale; of erlang: stages, mean
  std::int64_t lower, upper, from, to;
  double fires, survives, hazard;  ///< 0: too small for the table
};

constexpr Row table[] = {
#include "tests/unit/automata/time/density_table.inc"
};

Density density_of(const Row& row) {
  if (row.kind == Density::Kind::weibull) return {row.kind, 0, 0, row.mean, row.deviation};
  if (row.kind == Density::Kind::erlang) return {row.kind, row.deviation, 0, row.mean};
  return {row.kind, row.mean, row.deviation};
}

double relative_error(double is, double expected) { return std::abs(is - expected) / expected; }

TEST(DensityTable, IsMetToTwelveDigits) {
  for (const Row& row : table) {
    const Timing timing{{row.lower}, {row.upper}, density_of(row)};
    const Ticks from{row.from};
    const Ticks to{row.to};
    const auto compare = [&](double is, double expected, const char* what) {
      if (expected == 0) {
        EXPECT_LT(is, 1e-299);
        return;
      }
      EXPECT_LT(relative_error(is, expected), 1e-12)
          << what << ", row " << &row - table << ": mean " << row.mean << ", deviation " << row.deviation << ", from "
          << row.from << " to " << row.to << " in [" << row.lower << ", " << row.upper << "]: " << is << ", expected "
          << expected;
    };
    EXPECT_EQ(firing(timing, from, to), Firing::possible);
    compare(-std::expm1(-timing.step_hazard(from, to)), row.fires, "fires");
    compare(timing.step_survival(from, to), row.survives, "survives");
    compare(timing.step_hazard(from, to), row.hazard, "hazard");
  }
}

TEST(DensityTable, AScaledTailGoesOnForEver) {
  EXPECT_EQ(scaled_erfc(0), 1);
  EXPECT_NEAR(scaled_erfc(1e9) * 1e9, 0.5641895835477563, 1e-15);
}

}  // namespace
}  // namespace rmpl::automata
