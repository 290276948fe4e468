// What may come next in a text, by the grammar.
// SPDX-License-Identifier: MIT
#include "grammar/editor/expectation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rmpl::grammar {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

Expectation behind(Language language, std::string_view text) { return expected_after(language, open_statement(text)); }

TEST(Expectation, OfAnEmptyTextIsWhatALanguageBeginsWith) {
  EXPECT_THAT(behind(Language::tcca, "").words, Contains("component"));
  EXPECT_THAT(behind(Language::tcca, "").words, Not(Contains("when")));
  EXPECT_THAT(behind(Language::scn, "").words, ElementsAre("scenario"));
}

TEST(Expectation, FollowsTheRulesNotTheOrderOfWords) {
  const Expectation condition = behind(Language::rmpl, "P() :: { when ");
  EXPECT_THAT(condition.words, Contains("not"));
  EXPECT_THAT(condition.words, Not(Contains("donext")));
  EXPECT_THAT(condition.name_rules, Not(IsEmpty()));
  EXPECT_THAT(behind(Language::rmpl, "P() :: { when a = b ").words, Contains("donext"));
  EXPECT_THAT(behind(Language::rmpl, "P() :: { when a = b and ").words, Not(Contains("donext")));
}

TEST(Expectation, PassesOverATokenThatCannotStandThere) {
  EXPECT_THAT(behind(Language::rmpl, "P() :: { when = a = b ").words, Contains("donext"));
}

TEST(Expectation, IsThatOfTheBracketThatIsOpen) {
  const char* text = "component C { mode a; mode b { x = y } reward 1; a -> b ";
  EXPECT_THAT(behind(Language::tcca, text).words, Contains("when"));
  EXPECT_THAT(behind(Language::tcca, text).words, Not(Contains("component")));
}

TEST(OpenStatement, LeavesOutStatementsThatEndedAndWhatIsSaidAside) {
  EXPECT_THAT(open_statement("component C { mode a; mode b { x = y }; // mode c;\n a -> b "),
              ElementsAre("component", "C", "{", "a", "->", "b"));
}

TEST(OpenStatement, OfATextThatClosesMoreThanItOpensIsWhatFollows) {
  EXPECT_THAT(open_statement("} } ] x"), Contains("x"));
}

}  // namespace
}  // namespace rmpl::grammar
