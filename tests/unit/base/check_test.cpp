// CHECK: looked at once, in every build, and told with its place.
// SPDX-License-Identifier: MIT
#include "base/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rmpl::base {
namespace {

using testing::ThrowsMessage;

TEST(Check, TellsWhatWasExpectedAndWhere) {
  const int line = __LINE__ + 1;
  const auto fail = [] { CHECK(1 + 1 == 3 && "arithmetic"); };
  EXPECT_THAT(fail, ThrowsMessage<InternalError>("tests/unit/base/check_test.cpp:" + std::to_string(line) +
                                                 ": expected 1 + 1 == 3 && \"arithmetic\""));
}

TEST(Check, EvaluatesOnceWhateverTheBuild) {
  int looks = 0;
  CHECK(++looks == 1);
  EXPECT_EQ(looks, 1);
}

}  // namespace
}  // namespace rmpl::base
