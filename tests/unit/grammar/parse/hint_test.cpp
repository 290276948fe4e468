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
  EXPECT_EQ(in_component("* -> b with 0.1;"), "did you mean `any`? `any nominal` leaves out the faults");
  EXPECT_EQ(in_component("fault mode burnt { a = b };"), "a fault mode is declared `fault burnt`");
  EXPECT_EQ(in_component("a -> b with probability 0.1;"), "a probability is written `with 0.1`");
  EXPECT_EQ(in_component("a -> b with 1%;"), "a probability is a number from 0 to 1");
}

TEST(Hint, WhatBelongsToAMode) {
  EXPECT_EQ(in_component("mode a { b = c; d = e };"), "constraints are joined by `&`");
  EXPECT_EQ(in_component("fault a { b = c; };"), "no `;` before the `}`");
  EXPECT_EQ(in_component("mode a reward 2 { b = c };"),
            "the constraint comes before the reward: `mode m { … } reward 2;`");
  EXPECT_EQ(in_component("initial a reward 2;"), "a reward belongs to the mode: `mode m { … } reward 2;`");
  const test::Parsed<PlantFile> both(parse_plant,
                                     "component C {\n  mode a { b = c; d = e };\n  mode f { b = c; };\n  a -> f;\n}");
  EXPECT_EQ(both.diagnostics.all().size(), 2u);
}

TEST(Hint, ModesThatATransitionLeaves) {
  EXPECT_EQ(in_component("{ a, b } -> c when d = e;"),
            "the modes that a transition leaves are listed without braces: `a, b -> …`");
  const test::Parsed<PlantFile> set(parse_plant, "component C { { a, b } -> c when d = e; a -> b; }");
  EXPECT_EQ(set.diagnostics.all().size(), 1u);
}

TEST(Hint, WordsOfTemporalLogic) {
  const auto in_property = [](const std::string& claim) {
    const test::Parsed<PropertyFile> result(parse_properties, "property \"p\" { " + claim + " }");
    return result.diagnostics.empty() ? "no error" : result.diagnostics.all()[0].suggestion.value_or("no hint");
  };
  EXPECT_EQ(in_property("always a = b;"), "that c holds always is `never not (c)`");
  EXPECT_EQ(in_property("program always a = b;"), "that c holds always is `never not (c)`");
  EXPECT_EQ(in_property("reachable a = b;"), "did you mean `reach`?");
  EXPECT_EQ(
      in_property("eventually a = b within 5 s;"),
      "of runs under a program: `program eventually …`; of the plant alone: `after c within 5 s d`, or `reach c`");
}

TEST(Hint, UnitsAndValues) {
  EXPECT_EQ(in_component("a -> b after 30 sec;"), "did you mean `s`? Units of time are ns, us, ms, s, min, h, d and w");
  EXPECT_EQ(in_component("a -> b with rate 1 / hour;"),
            "did you mean `h`? Units of time are ns, us, ms, s, min, h, d and w");
  EXPECT_EQ(in_component("a -> b with 0.5 second;"),
            "did you mean `s`? Units of time are ns, us, ms, s, min, h, d and w");
  EXPECT_EQ(in_program("when t = 30 s donext a = b"), "a clock is compared with <, <=, > or >=");
  EXPECT_EQ(in_program("when a > b donext c = d"), "only clocks are compared with <, <=, > and >=");
  EXPECT_EQ(in_program("a = \"b\""), "a value is written without quotes");
  EXPECT_EQ(in_program("next = b"), "`next` is a reserved word and cannot be a name");
}

TEST(Hint, StatementsOfOtherLanguages) {
  const std::string during = "`do … maintaining c` runs while c is entailed, `whenever c donext …` again and again";
  EXPECT_EQ(in_program("while a = b do c = d"), during);
  EXPECT_EQ(in_program("while (a = b) { c = d }"), during);
  const std::string wait =
      "a wait is a `when`: `when c donext …`; for a time, a clock: `t = 0; when t >= 5 s donext …`";
  EXPECT_EQ(in_program("wait 5 s; a = b"), wait);
  EXPECT_EQ(in_program("wait until a = b; a = b"), wait);
  EXPECT_EQ(in_program("on a = b donext c = d"), "did you mean `when`?");
  EXPECT_EQ(in_program("parallel { a = b; c = d }"), "steps between `,` run side by side: `{ a, b }`");
  EXPECT_EQ(in_program("a = b; # then"), "a comment is written `// …` or `/* … */`");
  EXPECT_EQ(in_component("a -> b on c = d;"), "did you mean `when`?");
  EXPECT_EQ(in_component("clock t;"),
            "a component's clock counts from when its mode was entered, and bounds transitions: `a -> b after 5 s`, "
            "`in [2 s, 5 s]`");
  const test::Parsed<ProgramFile> procedure(parse_program, "procedure M() :: { a = b }");
  EXPECT_EQ(procedure.diagnostics.all().at(0).suggestion, "a definition is written `Name() :: { … }`");
}

TEST(Hint, OnlyProgramsHaveClocks) {
  EXPECT_EQ(in_component("mode a { x = 0 };"), "a value is a name, which begins with a letter: `zero`, `v0`");
  EXPECT_EQ(in_component("mode a { x > y };"), "values are compared with `=`, `!=` and `in` only");
  EXPECT_EQ(in_program("when x = 0 donext a = b"), "a clock is started by a step of its own: `t = 0`");
}

TEST(Hint, ModelProgramsHaveValuesAndNoClocks) {
  const auto hint_in = [](const char* text) {
    const test::Parsed<ProgramFile> result(parse_program, text);
    return result.diagnostics.all().at(0).suggestion;
  };
  EXPECT_EQ(hint_in("variable n : { 0, 1 };"), "a value is a name, which begins with a letter: `zero`, `v0`");
  EXPECT_EQ(hint_in("variable n : D; model M() :: { if n != 0 thennext n = a }"),
            "a value is a name, which begins with a letter: `zero`, `v0`");
  EXPECT_EQ(hint_in("model M() :: { T(3) }"),
            "an argument is a name or a constraint: there are no numbers to count with");
  EXPECT_EQ(hint_in("clock t; model M() :: { x = a }"),
            "a model program counts steps, and has no clocks: wait step by step, `next next …`");
  EXPECT_EQ(hint_in("clock t; M() :: { x = a }"),
            "a clock is declared in the definition that it belongs to: `Name() :: { clock t; … }`");
}

TEST(Hint, ReservedWordsAreNoNames) {
  const std::string in = "`in` is a reserved word and cannot be a name";
  EXPECT_EQ(in_component("input in : { a, b };"), in);
  EXPECT_EQ(in_component("mode in;"), in);
  EXPECT_EQ(in_component("in -> b;"), in);
  EXPECT_EQ(in_component("a -> b when in = c;"), in);
}

TEST(Hint, TimesAsClocksShowThem) {
  EXPECT_EQ(in_program("when t > 5min30s donext a = b"), "a duration has one unit: `330 s`");
  EXPECT_EQ(in_component("a -> b in [1h5min, 2 h];"), "a duration has one unit: `3900 s`");
  EXPECT_EQ(in_program("when t > 00:05:00 donext a = b"), "a time is a number and a unit: `300 s`");
  EXPECT_EQ(in_component("a -> b after 5:00;"), "a time is a number and a unit, as in `5 min`");
  EXPECT_EQ(in_component("any -> b with rate 0.001;"),
            "a rate is per unit of time, `with rate 0.001 /h`; a probability is `with 0.001`");
}

TEST(Hint, FixesAreEdits) {
  const test::Parsed<ProgramFile> result(parse_program, "M() :: { when t > 5min30s donext a = b }");
  const Diagnostic& error = result.diagnostics.all().at(0);
  ASSERT_EQ(error.fix.size(), 1u);
  EXPECT_EQ(result.sources.text(error.fix[0].span), "5min30s");
  EXPECT_EQ(error.fix[0].text, "330 s");
  const test::Parsed<PlantFile> missing(parse_plant, "component E {\n  mode a\n  mode b;\n}");
  EXPECT_EQ(missing.diagnostics.all().at(0).fix, (std::vector<Edit>{{{0, 22, 22}, ";"}}));
}

TEST(Hint, NothingWhereNothingIsNear) {
  EXPECT_EQ(in_program("a = b zzz"), "no hint");
  EXPECT_EQ(in_component("a -> b zzz;"), "no hint");
  EXPECT_FALSE(hint({"", "x", "", "a step"}));
  EXPECT_EQ(in_component("mode b { };"), "no error");
}

}  // namespace
}  // namespace rmpl::grammar
