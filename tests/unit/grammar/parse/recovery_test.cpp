// After an error the parse goes on: several errors in one run, each reported once, where it is.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/unit/grammar/parse/trees.hpp"

namespace rmpl::grammar {
namespace {

using test::Parsed;

TEST(Recovery, GoesOnAtTheNextStep) {
  EXPECT_EQ(Parsed<ProgramFile>(parse_program, R"(Main() :: {
  engine standby;
  when (t1 >= ) donext { a = on; b = off };
  do { a = b && c = d } watchng (x = y);
  do a = b;
  d = watching;
  e = f
}
Other() : { a = b }
Third( :: { a = b; })")
                .errors(),
            "2:10 expected `=`, `!=`, `in` or a comparison of a clock, found `standby`\n"
            "3:15 expected a duration, found `)`\n"
            "4:15 expected a constraint, found `&`\n"
            "4:25 expected `watching` or `maintaining`, found `watchng`\n"
            "5:11 expected `watching` or `maintaining`, found `;`\n"
            "6:7 expected a value, found the reserved word `watching`\n"
            "9:9 expected `::`, found `:`\n"
            "10:8 expected a parameter, `,` or `)`, found `::`\n");
}

TEST(Recovery, GoesOnAtTheNextStatement) {
  EXPECT_EQ(Parsed<PlantFile>(parse_plant, R"(component Engine {
  input    cmd   : { none, standby;
  output   thrust  { zero, full };
  mode  off     { thrust =  };
  fault failed  reward x;
  off     -> heating whn cmd = standby;
  heating -> standby in [30 s 60 s];
  off -> { a with 0.5, b };
  any  -> lost with rate 1e-6;
}
module X { a : ; control x defalt y; })")
                .errors(),
            "2:35 expected `,` or `}`, found `;`\n"
            "3:20 expected `,` or `:` and a domain, found `{`\n"
            "4:29 expected a value, found `}`\n"
            "5:24 expected a number, found `x`\n"
            "6:22 expected `when`, `in`, `after`, `with` or `;`, found `whn`\n"
            "7:31 expected `,`, found `60`\n"
            "8:26 expected `with`, found `}`\n"
            "9:30 expected `/`, found `;`\n"
            "11:16 expected a name, found `;`\n"
            "11:28 expected `,`, `default` or `;`, found `defalt`\n");
}

TEST(Recovery, SuggestsTheKeyword) {
  const Parsed<PlantFile> result(parse_plant, "compnent Engine { }");
  ASSERT_EQ(result.diagnostics.all().size(), 1u);
  EXPECT_EQ(result.diagnostics.all()[0].suggestion, "did you mean `component`?");
}

TEST(Recovery, NamesTheBracketThatIsNotClosedOrClosesNothing) {
  const Parsed<ProgramFile> open(parse_program, "M() :: { when (a = b donext c = d }");
  ASSERT_EQ(open.diagnostics.all().size(), 1u);
  EXPECT_EQ(open.errors(), "1:22 expected `)`, found the reserved word `donext`\n");
  ASSERT_EQ(open.diagnostics.all()[0].notes.size(), 1u);
  EXPECT_EQ(open.sources.text(open.diagnostics.all()[0].notes[0].span), "(");
  const Parsed<ProgramFile> stray(parse_program, "M() :: { a = b); c = d }");
  EXPECT_EQ(stray.diagnostics.all().at(0).suggestion, "no `(` is open here");
}

TEST(Recovery, AsksForTheSemicolonWhereALineLacksIt) {
  const Parsed<PlantFile> result(parse_plant, "component E {\n  mode a // first\n  mode b;\n}");
  EXPECT_EQ(result.errors(), "3:3 expected `{`, `reward` or `;`, found `mode`\n");
  ASSERT_EQ(result.diagnostics.all()[0].notes.size(), 1u);
  EXPECT_EQ(result.diagnostics.all()[0].notes[0].span.begin, 22u);
}

TEST(Recovery, AComponentThatIsNotClosedEndsBeforeTheNext) {
  const Parsed<PlantFile> result(parse_plant, "component E {\n  mode a;\nplant P { e : E; }\n");
  EXPECT_EQ(result.errors(), "3:1 expected `}`, found `plant`\n");
  EXPECT_TRUE(Parsed<PlantFile>(parse_plant,
                                "component E { mode plant; mode mode; initial plant;"
                                "plant -> mode; mode, plant -> plant; mode -> plant; }"
                                "plant P { input, output : E; control : E; input.c = output.c; }")
                  .tree);
}

TEST(Recovery, NamesTheBraceThatIsNotClosed) {
  const Parsed<PlantFile> result(parse_plant, "plant P {\n  a : B;\n");
  ASSERT_EQ(result.diagnostics.all().size(), 1u);
  EXPECT_EQ(result.errors(), "2:9 expected `}`, found the end of the text\n");
  ASSERT_EQ(result.diagnostics.all()[0].notes.size(), 1u);
  EXPECT_EQ(result.diagnostics.all()[0].notes[0].span.begin, 8u);
}

TEST(Recovery, StrayBracesAreErrorsAndNoEnd) {
  EXPECT_EQ(Parsed<ScenarioFile>(parse_scenarios, "} scenario \"s\" { seed x; }").errors(),
            "1:1 expected `scenario`, found `}`\n1:23 expected a whole number, found `x`\n");
}

TEST(Recovery, GivesUpAfterAHundredErrors) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "domain;\n";
  const Parsed<PlantFile> result(parse_plant, text);
  EXPECT_FALSE(result.tree);
  EXPECT_EQ(result.diagnostics.all().size(), 101u);
  EXPECT_EQ(result.diagnostics.all().back().code, Code::too_many_errors);
}

}  // namespace
}  // namespace rmpl::grammar
