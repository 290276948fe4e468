// A function that is lent.
// SPDX-License-Identifier: MIT
#include "base/function_ref.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rmpl::base {
namespace {

int twice(FunctionRef<int(int)> function) { return function(function(1)); }

TEST(FunctionRef, CallsWhatItRefersTo) {
  int calls = 0;
  const auto add = [&](int n) {
    ++calls;
    return n + 2;
  };
  EXPECT_EQ(twice(add), 5);
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(twice([](int n) { return 10 * n; }), 100);
}

TEST(FunctionRef, PassesOnWhatIsMoved) {
  std::string kept;
  const auto move = [&](std::string&& text) { kept = std::move(text); };
  const FunctionRef<void(std::string &&)> keep = move;
  keep("text");
  EXPECT_EQ(kept, "text");
}

}  // namespace
}  // namespace rmpl::base
