// What is said to habits of other languages.
// SPDX-License-Identifier: MIT
#include "grammar/parse/hint.hpp"

#include <gtest/gtest.h>

#include "tests/unit/grammar/parse/trees.hpp"

namespace rmpl::grammar {
namespace {

/// The suggestion of the first error of a body.
std::string in_program(const std::string& body) {
  const test::Parsed<ProgramFile> result(parse_program, "M() :: {" + body + "}");
  return result.diagnostics.empty() ? "no error" : result.diagnostics.all()[0].suggestion.value_or("no hint");
}

std::string in_component(const std::string& statement) {
  const test::Parsed<PlantFile> result(parse_plant, "component C {" + statement + "}");
  return result.diagnostics.empty() ? "no error" : result.diagnostics.all()[0].suggestion.value_or("no hint");
}

TEST(Hint, KeywordsOfOtherLanguages) {
  EXPECT_EQ(in_program("if a = b then c = d"), "did you mean `thennext`?");
  EXPECT_EQ(in_program("if a = b do c = d"), "did you mean `thennext`?");
  EXPECT_EQ(in_program("when a = b do c = d"), "did you mean `donext`?");
  EXPECT_EQ(in_program("unless a = b donext c = d"), "did you mean `thennext`?");
  EXPECT_EQ(in_program("if a = b thennext c = d else e = f"),
            "did you mean `elsenext`? It belongs to `if … thennext …`");
  EXPECT_EQ(in_program("do a = b watch c = d"), "did you mean `watching`?");
  EXPECT_EQ(in_program("a = b AND c = d"), "did you mean `and`?");
  EXPECT_EQ(in_component("a -> b if c = d;"), "did you mean `when`?");
}

TEST(Hint, MisspelledKeywords) {
  EXPECT_EQ(in_program("wehn a = b donext c = d"), "did you mean `when`?");
  EXPECT_EQ(in_program("if a = b thenext c = d"), "did you mean `thennext`?");
  EXPECT_EQ(in_component("mdoe off;"), "did you mean `mode`?");
}

TEST(Hint, Signs) {
  EXPECT_EQ(in_program("a == b"), "equality is written with one `=`");
  EXPECT_EQ(in_program("a := b"), "equality is written `=`");
  EXPECT_EQ(in_program("when a <> b donext c = d"), "`different` is written `!=`");
  EXPECT_EQ(in_program("a = b && c = d"), "`and` is written with one `&`");
  EXPECT_EQ(in_component("a => b;"), "an arrow is written `->`");
  EXPECT_EQ(in_component("a -> b with 1%;"), "a probability is a number from 0 to 1");
}

TEST(Hint, UnitsAndValues) {
  EXPECT_EQ(in_component("a -> b after 30 sec;"), "did you mean `s`? Units of time are us, ms, s, min, h and d");
  EXPECT_EQ(in_component("a -> b with rate 1 / hour;"), "did you mean `h`? Units of time are us, ms, s, min, h and d");
  EXPECT_EQ(in_component("a -> b with 0.5 second;"), "did you mean `s`? Units of time are us, ms, s, min, h and d");
  EXPECT_EQ(in_program("when t = 30 s donext a = b"), "a clock is compared with <, <=, > or >=");
  EXPECT_EQ(in_program("when a > b donext c = d"), "only clocks are compared with <, <=, > and >=");
  EXPECT_EQ(in_program("a = \"b\""), "a value is written without quotes");
  EXPECT_EQ(in_program("next = b"), "`next` is a reserved word and cannot be a name");
}

TEST(Hint, NothingWhereNothingIsNear) {
  EXPECT_EQ(in_program("a = b zzz"), "no hint");
  EXPECT_EQ(in_component("a -> b zzz;"), "no hint");
  EXPECT_FALSE(hint({"", "x", "", "a step"}));
}

}  // namespace
}  // namespace rmpl::grammar
