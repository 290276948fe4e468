// Sums and products of times at the end of their range.
// SPDX-License-Identifier: MIT
#include "automata/time/checked.hpp"

#include <gtest/gtest.h>

namespace rmpl::automata {
namespace {

constexpr Ticks last = {Ticks::infinite().count - 1};

TEST(CheckedTime, GoesUpToTheLastTick) {
  EXPECT_EQ(sum(last - Ticks{1}, Ticks{1}, "it"), last);
  EXPECT_EQ(product({last.count / 2}, 2, "it"), last);
  EXPECT_EQ(sum(Ticks::infinite(), last, "it"), Ticks::infinite());
}

TEST(CheckedTime, SaysWhatIsBeyondTheEnd) {
  EXPECT_THROW((void)sum(last, Ticks{1}, "it"), base::InputError);
  EXPECT_THROW((void)sum(last, last, "it"), base::InputError);
  try {
    (void)product(Ticks::of_seconds(86400), 1'000'000, "cycle 1000000");
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "cycle 1000000 is beyond the end of time, 9223372036.854775806 s (292 years); expected shorter or fewer "
        "durations");
  }
}

}  // namespace
}  // namespace rmpl::automata
