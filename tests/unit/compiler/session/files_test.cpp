// Files: kinds, imports, compiled documents, the command line's formulas.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "automata/json/document.hpp"
#include "base/error.hpp"
#include "compiler/session/files.hpp"
#include "grammar/source/render.hpp"
#include "tests/unit/compiler/workspace.hpp"

namespace rmpl::compiler {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* plant_text = R"(component Engine {
  input cmd : { none, on };
  output temp : { low, high };
  initial off;
  mode off; mode on { temp = high };
  off -> on when cmd = on;
}
plant Lander { engine : Engine; control engine.cmd default none; observe engine.temp; }
)";

class InputFiles : public Workspace {};

TEST_F(InputFiles, ImportsAreRelativeToTheImportingFile) {
  write("lib/valve.tcca", "import \"level.tcca\";\ncomponent Valve { input a : Level; mode m; initial m; }\n");
  write("lib/level.tcca", "domain Level = { low, high };\n");
  const Compilation result =
      compile_text("p.tcca", "import \"lib/valve.tcca\";\nimport \"lib/level.tcca\";\nplant P { v : Valve; }\n");
  EXPECT_THAT(findings(result), IsEmpty());
  EXPECT_THAT(result.document().plants, SizeIs(1));
}

TEST_F(InputFiles, AllThatCannotBeReadIsTold) {
  const std::vector<std::string> paths{"/no/a.tcca", write("p.tcca", plant_text), "/no/b.rmpl"};
  try {
    compile(paths);
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/no/a.tcca"));
    EXPECT_THAT(error.what(), HasSubstr("/no/b.rmpl"));
  }
}

TEST_F(InputFiles, ImportsThatFail) {
  EXPECT_THAT(errors("p.rmpl", "import \"no.rmpl\";\nP() :: { x = on }\n"), ElementsAre("RMPL0006 p.rmpl:1:8"));
  write("plant.tcca", plant_text);
  EXPECT_THAT(errors("q.rmpl", "import \"plant.tcca\";\nP() :: { x = on }\n"), ElementsAre("RMPL0006 q.rmpl:1:8"));
  write("b.rmpl", "import \"a.rmpl\";\nB() :: { x = on }\n");
  const Compilation cycle = compile_text("a.rmpl", "import \"b.rmpl\";\nA() :: { B() }\n");
  EXPECT_THAT(findings(cycle), ElementsAre("RMPL0007 b.rmpl:1:1"));
  EXPECT_THAT(notes(cycle), ElementsAre("a.rmpl:1:1"));
}

TEST_F(InputFiles, WhatCannotBeReadIsAnInputError) {
  EXPECT_THROW(compile_files({"/no/such/file.rmpl"}), base::InputError);
  EXPECT_THROW(compile_text("notes.txt", ""), base::InputError);
}

TEST_F(InputFiles, SeveralProgramFilesMakeOneProgram) {
  const Compilation result =
      compile_files({write("a.rmpl", "A() :: { x = on; B() }"), write("b.rmpl", "B() :: { y = on }")});
  EXPECT_THAT(findings(result), IsEmpty());
  EXPECT_EQ(result.document().programs.at(0).name, "A");
}

TEST_F(InputFiles, KindsAreToldByContent) {
  EXPECT_EQ(kind_by_content(" // comment\n { \"format\": 1 }"), Kind::document);
  EXPECT_EQ(kind_by_content("/* a */ scenario \"s\" { }"), Kind::scenario);
  EXPECT_EQ(kind_by_content("component C { }"), Kind::plant);
  EXPECT_EQ(kind_by_content("\xEF\xBB\xBF"
                            "component C { }"),
            Kind::plant);
  EXPECT_EQ(kind_by_content("plant P { }"), Kind::plant);
  EXPECT_EQ(kind_by_content("domain D = { a };"), Kind::plant);
  EXPECT_EQ(kind_by_content("domain D = { a }; /* b */ domain E = { a }; component C { }"), Kind::plant);
  EXPECT_EQ(kind_by_content("domain D = { a };\nvariable v : D; model M() :: { v = a }"), Kind::program);
  EXPECT_EQ(kind_by_content("domain D = { a"), Kind::plant);
  EXPECT_EQ(kind_by_content("domain() :: { x = on }"), Kind::program);
  EXPECT_EQ(kind_by_content("plant() :: { x = on }"), Kind::program);
  EXPECT_EQ(kind_by_content("import \"a.tcca\"; "), Kind::plant);
  EXPECT_EQ(kind_by_content("P() :: { x = on }"), Kind::program);
  EXPECT_EQ(kind_by_content(""), Kind::program);
}

TEST_F(InputFiles, CompiledDocumentsReadBack) {
  const Compilation sources = compile_files({write("p.tcca", plant_text), write("p.rmpl", "P() :: { engine = on }")});
  ASSERT_TRUE(sources.ok());
  const std::string text = automata::to_text(sources.document());
  const Compilation again = compile_text("p.json", text);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(automata::to_text(again.document()), text);
}

TEST_F(InputFiles, ProgramsCompiledAloneAreBoundToAPlant) {
  const Compilation alone = compile_text("p.rmpl", "P() :: { when engine.temp = high donext engine = on }");
  ASSERT_TRUE(alone.ok());
  const std::string program = write("p.json", automata::to_text(alone.document()));
  const Compilation both = compile_files({program, write("p.tcca", plant_text)});
  ASSERT_TRUE(both.ok());
  EXPECT_EQ(both.document().programs.at(0).variables, both.document().plants.at(0).variables);
}

TEST_F(InputFiles, WrongDocumentsAreLocated) {
  EXPECT_THAT(errors("p.json", "{ \"format\": }"), ElementsAre("RMPL0600 p.json:1:13"));
  EXPECT_THAT(errors("p.json", "{}"), ElementsAre("RMPL0600 p.json:1:1"));
}

TEST_F(InputFiles, EncodingErrorsAreLocated) {
  EXPECT_THAT(errors("p.rmpl", std::string("P() :: {\n x = \0on }", 18)),
              ElementsAre(HasSubstr("RMPL0002 p.rmpl:2:6")));
}

TEST_F(InputFiles, SameInputSameBytes) {
  const std::vector<std::string> paths{write("p.tcca", plant_text), write("p.rmpl", "P() :: { engine = on }")};
  EXPECT_EQ(automata::to_text(compile_files(paths).document()), automata::to_text(compile_files(paths).document()));
}

TEST_F(InputFiles, FormulasOfTheCommandLine) {
  const Compilation result = compile_text("p.tcca", plant_text);
  const automata::Plant& plant = result.document().plants.at(0);
  const CompiledFormula formula = compile_formula("engine = on & engine.temp != high", plant, "--target");
  ASSERT_TRUE(formula.formula);
  EXPECT_EQ(automata::to_text(*formula.formula, plant.variables), "engine = on & engine.temp = low");
  const CompiledFormula wrong = compile_formula("engine = of", plant, "--target");
  EXPECT_FALSE(wrong.formula);
  EXPECT_THAT(grammar::render_text(wrong.findings, false), HasSubstr("--target:1:10"));
  EXPECT_THAT(grammar::render_text(wrong.findings, false), HasSubstr("did you mean `off`?"));
  EXPECT_FALSE(compile_formula("engine =", plant, "--target").formula);
}

TEST_F(InputFiles, AssignmentsOfTheCommandLine) {
  const Compilation result = compile_text("p.tcca", plant_text);
  const automata::Plant& plant = result.document().plants.at(0);
  EXPECT_THAT(*compile_assignments("engine = on, engine.temp = high", plant, "--from").assignments, SizeIs(2));
  EXPECT_THAT(*compile_assignments("engine = on & engine.temp = high", plant, "--from").assignments, SizeIs(2));
  EXPECT_THAT(*compile_assignments("", plant, "--from").assignments, IsEmpty());
  EXPECT_FALSE(compile_assignments("engine = warm", plant, "--from").assignments);
}

}  // namespace
}  // namespace rmpl::compiler
