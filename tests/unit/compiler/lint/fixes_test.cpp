// Fixes are put in from the end, and none gets into another's way.
// SPDX-License-Identifier: MIT
#include "compiler/lint/fixes.hpp"

#include <gtest/gtest.h>

namespace rmpl::compiler {
namespace {

grammar::Diagnostic finding(std::vector<grammar::Edit> fix) {
  grammar::Diagnostic made;
  made.fix = std::move(fix);
  return made;
}

TEST(Fixes, ArePutInTogether) {
  grammar::Sources sources;
  sources.add("a", "one two three");
  sources.add("b", "four");
  const std::vector<grammar::Diagnostic> found{finding({{{0, 0, 3}, "1"}, {{0, 8, 13}, "3"}}),
                                               finding({{{0, 4, 7}, "2"}, {{1, 0, 0}, "a "}}), finding({})};
  const Fixed fixed = apply_fixes(found, sources);
  EXPECT_EQ(fixed.count, 2);
  EXPECT_EQ(fixed.left.size(), 1);
  EXPECT_EQ(fixed.texts, (std::map<std::uint32_t, std::string>{{0, "1 2 3"}, {1, "a four"}}));
}

TEST(Fixes, ThatMeetAreLeftForTheNextTime) {
  grammar::Sources sources;
  sources.add("a", "one two three");
  const std::vector<grammar::Diagnostic> found{
      finding({{{0, 4, 7}, "2"}}), finding({{{0, 0, 3}, "1"}, {{0, 6, 8}, "x"}}), finding({{{0, 7, 7}, "!"}})};
  const Fixed fixed = apply_fixes(found, sources);
  EXPECT_EQ(fixed.count, 1);
  EXPECT_EQ(fixed.left, (std::vector{found[1], found[2]}));
  EXPECT_EQ(fixed.texts.at(0), "one 2 three");
}

TEST(Fixes, ThatTakeOutWhatTouchesGoTogether) {
  grammar::Sources sources;
  sources.add("a", "one two three");
  const std::vector<grammar::Diagnostic> found{finding({{{0, 0, 4}, ""}}), finding({{{0, 4, 8}, ""}}),
                                               finding({{{0, 7, 9}, ""}})};
  const Fixed fixed = apply_fixes(found, sources);
  EXPECT_EQ(fixed.count, 2);
  EXPECT_EQ(fixed.texts.at(0), "three");
}

TEST(Fixes, KeepTheOneStyleWhereItWasThere) {
  const auto fixed = [](const std::string& text) {
    grammar::Sources sources;
    sources.add("a.rmpl", text);
    const auto begin = static_cast<std::uint32_t>(text.find('\n') + 1);
    const auto end = static_cast<std::uint32_t>(text.find(';') + 1);
    return apply_fixes(std::vector{finding({{{0, begin, end}, ""}})}, sources).texts.at(0);
  };
  EXPECT_EQ(fixed("P() :: {\n  clock t;\n  tap = open\n}\n"), "P() :: {\n  tap = open\n}\n");
  EXPECT_EQ(fixed("P()  :: {\n  clock t;\n  tap = open\n}\n"), "P()  :: {\n\n  tap = open\n}\n");
}

}  // namespace
}  // namespace rmpl::compiler
