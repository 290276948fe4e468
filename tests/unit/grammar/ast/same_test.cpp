// Trees are the same wherever they stand, and differ in whatever they say.
// SPDX-License-Identifier: MIT
#include "grammar/ast/same.hpp"

#include <gtest/gtest.h>

#include "grammar/parse/parse.hpp"

namespace rmpl::grammar {
namespace {

bool same_programs(const std::string& one, const std::string& other) {
  Sources sources;
  Diagnostics diagnostics;
  const auto first = parse_program(sources, sources.add("one", one), diagnostics);
  const auto second = parse_program(sources, sources.add("other", other), diagnostics);
  EXPECT_TRUE(first.whole && second.whole);
  return same(first.tree, second.tree);
}

TEST(Same, BlanksAndCommentsDoNotCount) {
  EXPECT_TRUE(same_programs("A() :: { do { x = on; y = off } watching z = on }",
                            "// a\nA()::{do{x=on;y=off}watching\n/* b */ (z=on)}"));
}

TEST(Same, WhatIsSaidCounts) {
  const std::string program = "A() :: { if x = on thennext y = off }";
  EXPECT_TRUE(same_programs(program, program));
  for (const char* other :
       {"B() :: { if x = on thennext y = off }", "A() :: { if x != on thennext y = off }",
        "A() :: { if x = off thennext y = off }", "A() :: { unless x = on thennext y = off }",
        "A() :: { if x = on thennext y = off elsenext z = on }", "A(x) :: { if x = on thennext y = off }",
        "A() :: { if x = on thennext y = off; z = on }", "A() :: { if t > 1 s thennext y = off }"}) {
    EXPECT_FALSE(same_programs(program, other)) << other;
  }
}

}  // namespace
}  // namespace rmpl::grammar
