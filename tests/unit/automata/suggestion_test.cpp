// The nearest name, or none.
// SPDX-License-Identifier: MIT
#include "automata/suggestion.hpp"

#include <gtest/gtest.h>

namespace rmpl::automata {
namespace {

TEST(Suggestion, NamesTheNearestOrNothing) {
  EXPECT_EQ(suggestion("standbi", {"off", "standby", "stand"}), "; did you mean 'standby'?");
  EXPECT_EQ(suggestion("paln", {"plan", "diagnose"}), "; did you mean 'plan'?");
  EXPECT_EQ(suggestion("engine", {"nav", "att"}), "");
  EXPECT_EQ(suggestion("x", {"y", "z"}), "") << "an edit of everything is no resemblance";
  EXPECT_EQ(suggestion("", {"a", ""}), "");
}

}  // namespace
}  // namespace rmpl::automata
