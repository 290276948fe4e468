// Control programs: the thesis's listings as printed, every step, what binds to what.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <bit>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "tests/paths.hpp"
#include "tests/unit/grammar/parse/trees.hpp"

namespace rmpl::grammar {
namespace {

using test::Parsed;

std::string body_of(const std::string& text) {
  const Parsed<ProgramFile> result(parse_program, "M() :: {" + text + "}");
  return result.tree ? test::tree(std::get<Definition>(result.tree->items.at(0)).body) : result.errors();
}

std::string listing(const std::string& name) {
  std::ifstream in(rmpl::paths::source() + "/tests/unit/grammar/listings/" + name + ".rmpl");
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

class Listings : public testing::TestWithParam<std::pair<const char*, std::size_t>> {};

TEST_P(Listings, ParseAsPrinted) {
  const Parsed<ProgramFile> result(parse_program, listing(GetParam().first));
  ASSERT_TRUE(result.tree) << result.errors();
  EXPECT_EQ(result.tree->items.size(), GetParam().second);
}

INSTANTIATE_TEST_SUITE_P(Thesis, Listings,
                         testing::Values(std::pair("fig_3_2", 1), std::pair("fig_5_1", 3), std::pair("fig_b_1", 1),
                                         std::pair("fig_b_2", 1), std::pair("fig_b_3", 1), std::pair("fig_b_4", 1)));

TEST(ProgramParse, MarsEntryIsTheTreeOfFigure32) {
  const Parsed<ProgramFile> result(parse_program, listing("fig_3_2"));
  ASSERT_TRUE(result.tree);
  EXPECT_EQ(test::tree(std::get<Definition>(result.tree->items[0]).body),
            "[engine=standby; (start t1); (when t1>=270.0 [nav=inertial; (start t2); (when t2>=4.0 "
            "[(watching entry=initiated [(always att=entry-orient), (when att=entry-orient lander=separated)])])])]");
}

TEST(ProgramParse, SemicolonsBindTighterThanCommas) {
  EXPECT_EQ(body_of("a = x; b = x, c = x; d = x"), "[a=x; b=x, c=x; d=x]");
  EXPECT_EQ(body_of("{a = x, b = x}; c = x;"), "[[a=x, b=x]; c=x]");
}

TEST(ProgramParse, EveryStep) {
  EXPECT_EQ(body_of("if c = x thennext a = x elsenext b = x"), "[(if c=x a=x b=x)]");
  EXPECT_EQ(body_of("if c = x thennext if d = x thennext a = x elsenext b = x"), "[(if c=x (if d=x a=x b=x))]");
  EXPECT_EQ(body_of("unless c = x thennext a = x"), "[(unless c=x a=x)]");
  EXPECT_EQ(body_of("whenever c = x donext always next a = x"), "[(whenever c=x (always (next a=x)))]");
  EXPECT_EQ(body_of("F(), G(a, x = y & b = z, true)"), "[(call F), (call G a (& x=y b=z) true)]");
  EXPECT_EQ(body_of("choose { a = x with 0.9, { b = x } with 0.1 }"), "[(choose 0.9:a=x 0.1:[b=x])]");
  EXPECT_EQ(body_of("(a = x & b = y)"), "[(& a=x b=y)]");
}

TEST(ProgramParse, MaintainingBindsToTheNearestStep) {
  EXPECT_EQ(body_of("when c = x donext a = x maintaining d = x"), "[(when c=x (maintaining d=x a=x))]");
  EXPECT_EQ(body_of("{ when c = x donext a = x } maintaining d = x"), "[(maintaining d=x [(when c=x a=x)])]");
  EXPECT_EQ(body_of("a = x maintaining c = x maintaining d = x"), "[(maintaining d=x (maintaining c=x a=x))]");
}

TEST(ProgramParse, ADoTakesTheMaintainingThatItNeeds) {
  EXPECT_EQ(body_of("do a = x maintaining c = x"), "[(do-maintaining c=x a=x)]");
  EXPECT_EQ(body_of("do when b = x donext a = x maintaining c = x"), "[(do-maintaining c=x (when b=x a=x))]");
  EXPECT_EQ(body_of("do a = x maintaining c = x watching d = x"), "[(watching d=x (maintaining c=x a=x))]");
  EXPECT_EQ(body_of("do do a = x maintaining c = x maintaining d = x"),
            "[(do-maintaining d=x (do-maintaining c=x a=x))]");
  EXPECT_EQ(body_of("do always do a = x watching c = x maintaining d = x"),
            "[(do-maintaining d=x (always (watching c=x a=x)))]");
}

TEST(ProgramParse, AnInnerDoGivesAwayWhatTheOuterOneNeeds) {
  EXPECT_EQ(body_of("do do {a = x} maintaining b = x watching c = x"), "[(watching c=x (do-maintaining b=x [a=x]))]");
  EXPECT_EQ(body_of("do when d = x donext do a = x maintaining b = x watching c = x"),
            "[(watching c=x (when d=x (do-maintaining b=x a=x)))]");
  EXPECT_EQ(body_of("do do do a = x maintaining b = x watching c = x watching d = x"),
            "[(watching d=x (watching c=x (do-maintaining b=x a=x)))]");
  EXPECT_EQ(body_of("do do a = x watching b = x maintaining c = x"), "[(do-maintaining c=x (watching b=x a=x))]");
  EXPECT_EQ(body_of("do do a = x watching b = x"), "1:35 expected `watching` or `maintaining`, found `}`\n");
}

/// Whether the grammar has this step: `d` is do, `a` a goal, `m` and `w` are maintaining and watching. The slow,
/// obvious twin of how the parser hands endings from one `do` to the next.
bool derives(std::string_view step) {
  if (step == "a") return true;
  if (step.size() < 2) return false;
  const char last = step.back();
  if (last == 'm' && derives(step.substr(0, step.size() - 1))) return true;
  return step.front() == 'd' && (last == 'm' || last == 'w') && derives(step.substr(1, step.size() - 2));
}

TEST(ProgramParse, ReadsEveryNestingOfDoThatTheGrammarHasAndNoOther) {
  std::size_t read = 0;
  for (std::size_t dos = 0; dos <= 6; ++dos) {
    for (unsigned endings = 1; endings < 1u << 8; ++endings) {  // a leading 1, then one bit an ending
      std::string letters = std::string(dos, 'd') + "a";
      for (int bit = static_cast<int>(std::bit_width(endings)) - 2; bit >= 0; --bit)
        letters += (endings >> bit & 1) != 0 ? 'm' : 'w';
      std::string text;
      for (const char c : letters) {
        text += c == 'd' ? "do " : c == 'a' ? "x = a " : c == 'm' ? "maintaining c = d " : "watching e = f ";
      }
      const Parsed<ProgramFile> result(parse_program, "M() :: { " + text + "}");
      EXPECT_EQ(result.tree.has_value(), derives(letters)) << letters << '\n' << result.errors();
      read += result.tree.has_value() ? 1 : 0;
    }
  }
  EXPECT_GT(read, 300u);
}

TEST(ProgramParse, PlacesFollowADetachedCondition) {
  const Parsed<ProgramFile> result(parse_program, "M() :: { do when b = x donext a = x maintaining c = x }");
  ASSERT_TRUE(result.tree);
  const Step& whole = std::get<Definition>(result.tree->items[0]).body.threads[0].steps[0];
  EXPECT_EQ(result.sources.text(whole.span), "do when b = x donext a = x maintaining c = x");
  EXPECT_EQ(result.sources.text(std::get<Maintaining>(whole.node).step->span), "when b = x donext a = x");
}

TEST(ProgramParse, ItemsOfAFile) {
  const Parsed<ProgramFile> result(parse_program,
                                   "import \"a.rmpl\"; domain D = { x, y }; variable v, w : D; observe v;"
                                   "control w default x; model M() :: { v = w } N(p, q) :: { p = q; }"
                                   "model() :: { a = x } variable() :: { a = x }");
  ASSERT_TRUE(result.tree) << result.errors();
  ASSERT_EQ(result.tree->items.size(), 9u);
  EXPECT_EQ(std::get<Import>(result.tree->items[0]).path.text, "a.rmpl");
  EXPECT_TRUE(std::get<Definition>(result.tree->items[5]).model);
  EXPECT_EQ(std::get<Definition>(result.tree->items[6]).parameters.size(), 2u);
  EXPECT_EQ(std::get<Definition>(result.tree->items[7]).name.text, "model");
  EXPECT_EQ(std::get<Definition>(result.tree->items[8]).name.text, "variable");
}

TEST(ProgramParse, StandingConstraints) {
  const Parsed<ProgramFile> result(parse_program,
                                   "constraint v = x | w = x; constraint (v = x); constraint (p);"
                                   "constraint() :: { a = x } constraint(p, q) :: { p = q }");
  ASSERT_TRUE(result.tree) << result.errors();
  ASSERT_EQ(result.tree->items.size(), 5u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(std::holds_alternative<StandingConstraint>(result.tree->items[i]));
  EXPECT_EQ(std::get<Definition>(result.tree->items[3]).name.text, "constraint");
  EXPECT_EQ(std::get<Definition>(result.tree->items[4]).parameters.size(), 2u);
}

TEST(ProgramParse, AClockStartsAtZeroOnly) {
  EXPECT_EQ(body_of(" t = 5"), "1:14 expected a value, or `0` where a clock starts, found `5`\n");
  const Parsed<ProgramFile> result(parse_program, "M() :: { (t = 0) }");
  EXPECT_EQ(result.errors(), "1:15 expected a value, found `0`\n");
  EXPECT_EQ(result.diagnostics.all()[0].suggestion, "a clock is started by a step of its own: `t = 0`");
}

}  // namespace
}  // namespace rmpl::grammar
