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

TEST(Printable, EscapesWhatSteersBeyondAscii) {
  EXPECT_EQ(printable("a\u009b31mb"), "a\\u009b31mb");
  EXPECT_EQ(printable("\u0080\u009f"), "\\u0080\\u009f");
  EXPECT_EQ(printable("\u202a\u202e\u2066\u2069"), "\\u202a\\u202e\\u2066\\u2069");
  EXPECT_EQ(printable("\u00a0\u2029\u202f\u2065\u206a"), "\u00a0\u2029\u202f\u2065\u206a");
  EXPECT_EQ(printable("\xff\x9b\xc3"), "\\xff\\x9b\\xc3");  // no UTF-8
}

TEST(Printable, LeavesColoursOfOurOwn) {
  EXPECT_EQ(printable_in_colour("\x1b[1;31mred\x1b[0m\tplain\u009b"), "\x1b[1;31mred\x1b[0m\tplain\\u009b");
  EXPECT_EQ(printable_in_colour("\x1b[2J\x1b[1m\x1b]0;title\x07\x1b["), "\\x1b[2J\x1b[1m\\x1b]0;title\\x07\\x1b[");
  EXPECT_EQ(printable_in_colour("plain\n"), "plain\n");
}

TEST(Printable, LeavesTheValuesOfJson) {
  EXPECT_EQ(printable_json("{\"a\":\n\t\"\u009b \u202e \x7f ü\"}"), "{\"a\":\n\t\"\\u009b \\u202e \\u007f ü\"}");
}

TEST(Printable, LeavesLinesAndOtherLanguagesAlone) { EXPECT_EQ(printable("φ ≥ 5\nnäher"), "φ ≥ 5\nnäher"); }

}  // namespace
}  // namespace rmpl::base
