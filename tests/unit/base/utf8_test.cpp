// UTF-8, well-formed and not.
// SPDX-License-Identifier: MIT
#include "base/utf8.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rmpl::base {
namespace {

TEST(Utf8, KnowsWellFormedCodePoints) {
  EXPECT_EQ(code_point_length("a"), 1u);
  EXPECT_EQ(code_point_length("é"), 2u);
  EXPECT_EQ(code_point_length("≥"), 3u);
  EXPECT_EQ(code_point_length("🚀"), 4u);
  for (const char* wrong :
       {"", "\x80", "\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x89", "\xFF"})
    EXPECT_EQ(code_point_length(wrong), 0u) << wrong;
}

TEST(Utf8, CountsCodePoints) {
  EXPECT_EQ(code_points(""), 0u);
  EXPECT_EQ(code_points("t1 ≥ é🚀"), 7u);
  std::string text;
  for (std::size_t n = 1; n < 40; ++n) {
    text += n % 3 == 0 ? "🚀" : n % 2 == 0 ? "≥" : "a";
    EXPECT_EQ(code_points(text), n);
  }
}

}  // namespace
}  // namespace rmpl::base
