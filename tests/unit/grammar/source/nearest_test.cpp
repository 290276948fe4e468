// Edit distance and the nearest name.
// SPDX-License-Identifier: MIT
#include "grammar/source/nearest.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rmpl::grammar {
namespace {

TEST(EditDistance, CountsEdits) {
  EXPECT_EQ(edit_distance("thrust", "thrust", 9), 0u);
  EXPECT_EQ(edit_distance("thurst", "thrust", 9), 1u);
  EXPECT_EQ(edit_distance("thrst", "thrust", 9), 1u);
  EXPECT_EQ(edit_distance("kitten", "sitting", 9), 3u);
  EXPECT_EQ(edit_distance("", "abc", 9), 3u);
  EXPECT_EQ(edit_distance("abcdef", "uvwxyz", 2), 3u);
}

TEST(Nearest, FindsTypingErrorsOnly) {
  const std::vector<std::string> names = {"engine", "lander", "on", "Temp"};
  EXPECT_EQ(nearest("engin", names), "engine");
  EXPECT_EQ(nearest("ENGINE", names), "engine");
  EXPECT_EQ(nearest("temp", names), "Temp");
  EXPECT_EQ(nearest("landr", names), "lander");
  EXPECT_EQ(nearest("parachute", names), std::nullopt);
  EXPECT_EQ(nearest("xy", names), std::nullopt);
  EXPECT_EQ(nearest("engine", {}), std::nullopt);
}

TEST(Nearest, TheFirstOfEqualsWins) {
  const std::vector<std::string> names = {"valve1", "valve2"};
  EXPECT_EQ(nearest("valve3", names), "valve1");
}

}  // namespace
}  // namespace rmpl::grammar
