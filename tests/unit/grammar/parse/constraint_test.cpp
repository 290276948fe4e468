// Constraints and lists of assignments: precedence, spellings, places.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/unit/grammar/parse/trees.hpp"

namespace rmpl::grammar {
namespace {

using test::Parsed;

std::string parsed(const std::string& text) {
  const Parsed<Constraint> result(parse_constraint, text);
  return result.tree ? test::tree(*result.tree) : result.errors();
}

TEST(ConstraintParse, BindsFromNotToEquivalence) {
  EXPECT_EQ(parsed("a = x & b = y | c = z -> d = v <-> e = w"), "(<-> (-> (| (& a=x b=y) c=z) d=v) e=w)");
  EXPECT_EQ(parsed("!a = x & b = y"), "(& (! a=x) b=y)");
  EXPECT_EQ(parsed("a = x & (b = y | c = z)"), "(& a=x (| b=y c=z))");
}

TEST(ConstraintParse, ChainsAreFlatOrNestAsTheGrammarSays) {
  EXPECT_EQ(parsed("a = x & b = x & c = x"), "(& a=x b=x c=x)");
  EXPECT_EQ(parsed("(a = x & b = x) & c = x"), "(& (& a=x b=x) c=x)");
  EXPECT_EQ(parsed("a = x -> b = x -> c = x"), "(-> a=x (-> b=x c=x))");
  EXPECT_EQ(parsed("a = x <-> b = x <-> c = x"), "(<-> (<-> a=x b=x) c=x)");
}

TEST(ConstraintParse, EachOperatorHasItsSpellings) {
  EXPECT_EQ(parsed("¬a = x ∧ b ≠ y ∨ t ≥ 1 ⇒ u ≤ 2 ⇔ true"),
            parsed("not a = x and b != y or t >= 1 -> u <= 2 <-> true"));
  EXPECT_EQ(parsed("t<1&u>2"), "(& t<1 u>2)");
}

TEST(ConstraintParse, NamesHoldDashesAndDotsButNoOperators) {
  EXPECT_EQ(parsed("Mach.trigger = not-triggered"), "Mach.trigger=not-triggered");
  EXPECT_EQ(parsed("a=b->c=d"), "(-> a=b c=d)");
  EXPECT_EQ(parsed("a.1 = b-2"), "a.1=b-2");
}

TEST(ConstraintParse, KeywordsOfOtherPlacesAreNames) {
  EXPECT_EQ(parsed("radar_altim = on & temp = nominal & mode = fault"), "(& radar_altim=on temp=nominal mode=fault)");
  EXPECT_EQ(parsed("x = true | y in {true, false}"), "(| x=true y in {true false})");
}

TEST(ConstraintParse, ClocksAreComparedWithDurations) {
  EXPECT_EQ(parsed("t1 ≥ 19 mins"), "t1>=19mins");
  EXPECT_EQ(parsed("t1 >= 16200.0"), "t1>=16200.0");
  EXPECT_EQ(parsed("t1 < 1e-3ms"), "t1<1e-3ms");
  EXPECT_EQ(parsed("t1 >= 3 donkeys"), "1:9 expected the end of the text, found `donkeys`\n");
}

TEST(ConstraintParse, CommentsAreBlanks) {
  EXPECT_EQ(parsed("a /* the variable */ = // its value\n x"), "a=x");
  EXPECT_EQ(parsed("a = x /* never"), "1:7 this comment is not closed: expected `*/`\n");
}

TEST(ConstraintParse, ABareNameIsAReference) {
  EXPECT_EQ(parsed("c & !d"), "(& c (! d))");
  EXPECT_EQ(parsed("c d"), "1:3 expected `=`, `!=` or `in`, found `d`\n");
}

TEST(ConstraintParse, PlacesIncludeParentheses) {
  const Parsed<Constraint> result(parse_constraint, "  (a = x) & b = y ");
  ASSERT_TRUE(result.tree);
  EXPECT_EQ(result.sources.text(result.tree->span), "(a = x) & b = y");
  const auto& both = std::get<Conjunction>(result.tree->node);
  EXPECT_EQ(result.sources.text(both.operands[0].span), "(a = x)");
  EXPECT_EQ(result.sources.text(std::get<Comparison>(both.operands[0].node).right.span), "x");
}

TEST(ConstraintParse, HabitsOfOtherLanguagesGetAHint) {
  const Parsed<Constraint> result(parse_constraint, "a == x");
  ASSERT_EQ(result.diagnostics.all().size(), 1u);
  EXPECT_EQ(result.diagnostics.all()[0].suggestion, "equality is written with one `=`");
}

TEST(AssignmentsParse, TakesCommasAndConjunctions) {
  const Parsed<std::vector<AssignmentText>> result(parse_assignments, "a = x, b.c = y & d = true");
  ASSERT_TRUE(result.tree);
  ASSERT_EQ(result.tree->size(), 3u);
  EXPECT_EQ((*result.tree)[1].variable.text, "b.c");
  EXPECT_EQ((*result.tree)[2].value.text, "true");
}

TEST(AssignmentsParse, NothingIsAnEmptyList) {
  const Parsed<std::vector<AssignmentText>> result(parse_assignments, " ");
  ASSERT_TRUE(result.tree);
  EXPECT_TRUE(result.tree->empty());
}

TEST(AssignmentsParse, RefusesWhatIsNoAssignment) {
  EXPECT_EQ(Parsed<std::vector<AssignmentText>>(parse_assignments, "a = x,").errors(),
            "1:7 expected an assignment, found the end of the text\n");
  EXPECT_EQ(Parsed<std::vector<AssignmentText>>(parse_assignments, "a != x").errors(),
            "1:3 expected `=`, found `!=`\n");
}

}  // namespace
}  // namespace rmpl::grammar
