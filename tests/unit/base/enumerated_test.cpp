// Lists in words.
// SPDX-License-Identifier: MIT
#include "base/enumerated.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rmpl::base {
namespace {

TEST(Enumerated, LinksTheLastTwo) {
  EXPECT_EQ(enumerated({}), "");
  EXPECT_EQ(enumerated(std::vector<std::string>{"a"}), "a");
  EXPECT_EQ(enumerated(std::vector<std::string>{"a", "b"}), "a and b");
  EXPECT_EQ(enumerated(std::vector<std::string>{"a", "b", "c"}, "or"), "a, b or c");
}

}  // namespace
}  // namespace rmpl::base
