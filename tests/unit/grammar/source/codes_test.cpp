// The registry of codes is complete and keeps its word.
// SPDX-License-Identifier: MIT
#include "grammar/source/codes.hpp"

#include <gtest/gtest.h>

#include <set>

namespace rmpl::grammar {
namespace {

TEST(Codes, HaveOneFullEntryEach) {
  std::set<Code> seen;
  for (const CodeInfo& entry : all_codes()) {
    EXPECT_TRUE(seen.insert(entry.code).second) << to_string(entry.code);
    EXPECT_FALSE(entry.title.empty() || entry.explanation.empty() || entry.wrong.empty() || entry.right.empty())
        << to_string(entry.code);
    EXPECT_NE(entry.wrong, entry.right);
    EXPECT_EQ(find_code(to_string(entry.code)), entry.code);
    EXPECT_EQ(info(entry.code).title, entry.title);
  }
}

TEST(Codes, AreFoundInTheirSpellings) {
  EXPECT_EQ(to_string(Code::syntax), "RMPL0001");
  EXPECT_EQ(find_code("RMPL0001"), Code::syntax);
  EXPECT_EQ(find_code("rmpl0100"), Code::unknown_name);
  EXPECT_EQ(find_code("1"), Code::syntax);
  for (const char* none : {"", "RMPL", "RMPL9999", "RMPL0001x", "70000"})
    EXPECT_EQ(find_code(none), std::nullopt) << none;
}

}  // namespace
}  // namespace rmpl::grammar
