// Edit distance and the nearest name.
// SPDX-License-Identifier: MIT
#include "base/nearest.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rmpl::base {
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
  EXPECT_EQ(nearest("engine", std::vector<std::string>{}), std::nullopt);
}

TEST(Nearest, TheFirstOfEqualsWins) {
  const std::vector<std::string> names = {"valve1", "valve2"};
  EXPECT_EQ(nearest("valve3", names), "valve1");
}

TEST(Suggestion, NamesTheNearestOrNothing) {
  const auto suggested = [](std::string_view name, const std::vector<std::string_view>& names) {
    return suggestion(name, names);
  };
  EXPECT_EQ(suggested("standbi", {"off", "standby", "stand"}), "; did you mean 'standby'?");
  EXPECT_EQ(suggested("paln", {"plan", "diagnose"}), "; did you mean 'plan'?");
  EXPECT_EQ(suggested("engine", {"nav", "att"}), "");
  EXPECT_EQ(suggested("x", {"y", "z"}), "") << "an edit of everything is no resemblance";
  EXPECT_EQ(suggested("", {"a", ""}), "");
}

}  // namespace
}  // namespace rmpl::base
