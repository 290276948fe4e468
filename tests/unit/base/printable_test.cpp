// Control characters are shown, not obeyed.
// SPDX-License-Identifier: MIT
#include "base/printable.hpp"

#include <gtest/gtest.h>

namespace rmpl::base {
namespace {

TEST(Printable, ShowsControlCharactersByNumber) {
  EXPECT_EQ(printable("\x1b[31mred\x7f"), "\\x1b[31mred\\x7f");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
}

TEST(Printable, LeavesLinesAndOtherLanguagesAlone) { EXPECT_EQ(printable("φ ≥ 5\nnäher"), "φ ≥ 5\nnäher"); }

}  // namespace
}  // namespace rmpl::base
