// Densities against the formulas of thesis 6.2.2, and far out in their tails.
// SPDX-License-Identifier: MIT
#include "automata/time/density.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rmpl::automata {
namespace {

Ticks s(double seconds) { return *ticks_from_seconds(seconds); }

TEST(Density, UniformBetweenItsBounds) {
  const Timing heating{s(30), s(60), {}};
  EXPECT_EQ(heating.survival(s(0)), 1);
  EXPECT_EQ(heating.survival(s(30)), 1);
  EXPECT_NEAR(heating.survival(s(45)), 0.5, 1e-15);
  EXPECT_EQ(heating.survival(s(60)), 0);
  EXPECT_NEAR(heating.step_survival(s(45), s(50)), 10.0 / 15.0, 1e-15);
  EXPECT_EQ(heating.step_survival(s(60), s(61)), 0);
  EXPECT_EQ(heating.step_hazard(s(29), s(30)), 0);
  EXPECT_TRUE(std::isinf(heating.step_hazard(s(59), s(60))));
}

TEST(Density, PointMassFiresInTheStepThatReachesIt) {
  const Timing after{s(5), s(5), {}};
  EXPECT_EQ(after.step_survival(s(4), s(4.9)), 1);
  EXPECT_EQ(after.step_survival(s(4.9), s(5)), 0);
  EXPECT_EQ(after.step_survival(s(6), s(7)), 0);
}

TEST(Density, ExponentialHasNoMemory) {
  const Timing decay{s(0), Ticks::infinite(), {Density::Kind::exponential, 100, 0}};
  const double step = std::exp(-0.005);
  EXPECT_NEAR(decay.step_survival(s(0), s(0.5)), step, 1e-15);
  EXPECT_NEAR(decay.step_survival(s(5000), s(5000.5)), step, 1e-12);
}

TEST(Density, ExponentialIsTheSameAtEveryAge) {
  const Timing decay{s(0), Ticks::infinite(), {Density::Kind::exponential, 1, 0}};
  for (const double age : {0.0, 700.0, 744.0, 746.0, 1e6, 4e9}) {
    EXPECT_NEAR(1 - decay.step_survival(s(age), s(age + 1)), 0.63212055882855768, 1e-15) << age;
  }
}

TEST(Density, TruncatedExponentialIsRescaled) {
  const Timing decay{s(10), s(20), {Density::Kind::exponential, 7, 0}};
  const auto g = [](double x) {
    return (std::exp(-10 / 7.0) - std::exp(-x / 7.0)) / (std::exp(-10 / 7.0) - std::exp(-20 / 7.0));
  };
  for (double x = 10; x <= 20; x += 0.5) EXPECT_NEAR(decay.survival(s(x)), 1 - g(x), 1e-12) << x;
}

TEST(Density, TruncatedNormalIsRescaled) {
  const Timing entry{s(90), s(130), {Density::Kind::normal, 100, 10}};
  const auto phi = [](double x) { return 0.5 * std::erfc(-(x - 100) / 10 / std::sqrt(2.0)); };
  for (double x = 90; x <= 130; x += 2.5) {
    EXPECT_NEAR(entry.survival(s(x)), 1 - (phi(x) - phi(90)) / (phi(130) - phi(90)), 1e-12) << x;
  }
}

TEST(Density, NormalTailKeepsItsHazard) {
  const Timing entry{s(0), Ticks::infinite(), {Density::Kind::normal, 100, 10}};
  // Ten standard deviations out, 1 - G is 7.6e-24: as a difference of Gs the step would be 0/0.
  const double survival = entry.step_survival(s(200), s(201));
  EXPECT_GT(survival, 0.3);
  EXPECT_LT(survival, 0.4);
}

}  // namespace
}  // namespace rmpl::automata
