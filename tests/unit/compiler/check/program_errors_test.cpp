// Every error of a control program, with its code and place.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "tests/unit/compiler/workspace.hpp"

namespace rmpl::compiler {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ProgramErrors : public Workspace {
 protected:
  /// The findings in a body that starts on line 2.
  std::vector<std::string> in_body(const std::string& line) { return errors("p.rmpl", "P() :: {\n" + line + "\n}\n"); }

  /// The findings in a body that is checked against a plant.
  std::vector<std::string> over_plant(const std::string& text) {
    const std::string plant = write("p.tcca", R"(component Engine {
  output temp : { low, high };
  mode off; mode on;
  initial off;
}
plant Lander { engine : Engine; })");
    return findings(compile_files({write("p.rmpl", text), plant}));
  }
};

TEST_F(ProgramErrors, Definitions) {
  EXPECT_THAT(errors("p.rmpl", "A() :: { x = on }\nA() :: { y = on }\n"), ElementsAre("RMPL0101 p.rmpl:2:1"));
  EXPECT_THAT(errors("p.rmpl", "A(v, v) :: { v = on }\nB() :: { A(x, y) }\n"), ElementsAre("RMPL0101 p.rmpl:1:6"));
  EXPECT_THAT(in_body("Q()"), ElementsAre("RMPL0100 p.rmpl:2:1"));
  EXPECT_THAT(errors("p.rmpl", "A(v) :: { v = on }\nB() :: { A() }\n"), ElementsAre("RMPL0305 p.rmpl:2:10"));
  EXPECT_THAT(errors("p.rmpl", "A(v) :: { v = on }\n"), ElementsAre("RMPL0305 p.rmpl:1:1"));
}

TEST_F(ProgramErrors, EntryPoints) {
  EXPECT_THAT(errors("p.rmpl", "A() :: { x = on }\nB() :: { x = on }\n"), ElementsAre("RMPL0306 p.rmpl:2:1"));
  EXPECT_THAT(errors("p.rmpl", "A() :: { x = on; B() }\nB() :: { x = on; A() }\n"), ElementsAre("RMPL0307 p.rmpl:1:1"));
  const Compilation named = compile_text("q.rmpl", "A() :: { x = on }\nB() :: { x = on }\n", {"B"});
  EXPECT_TRUE(named.ok());
  EXPECT_EQ(named.document().programs.at(0).name, "B");
  EXPECT_THAT(findings(compile_text("q.rmpl", "A() :: { x = on }\n", {"C"})), ElementsAre("RMPL0307 q.rmpl:1:1"));
}

TEST_F(ProgramErrors, Goals) {
  EXPECT_THAT(in_body("engine = on | nav = on"), IsEmpty());
  EXPECT_THAT(in_body("engine != on"), IsEmpty());
  EXPECT_THAT(in_body("!(engine = on)"), IsEmpty());
  EXPECT_THAT(in_body("engine in { on, off }"), IsEmpty());
  EXPECT_THAT(in_body("engine = on -> nav = on"), IsEmpty());
  EXPECT_THAT(in_body("false"), ElementsAre("RMPL0323 p.rmpl:2:1"));
  EXPECT_THAT(in_body("t = 0; t >= 3 s"), ElementsAre("RMPL0301 p.rmpl:2:8"));
  EXPECT_THAT(in_body("engine = on & engine = off"), ElementsAre("RMPL0311 p.rmpl:2:15"));
  EXPECT_THAT(in_body("(engine = on & (nav = on & acs = on))"), IsEmpty());
}

TEST_F(ProgramErrors, Knowledge) {
  EXPECT_THAT(in_body("when surprise donext x = on"), IsEmpty());
  EXPECT_THAT(in_body("when surprise = on donext x = on"), IsEmpty());
  EXPECT_THAT(in_body("whenever noplan(engine) & possible(x = on) donext { }"), IsEmpty());
  EXPECT_THAT(in_body("surprise"), ElementsAre("RMPL0322 p.rmpl:2:1"));
  EXPECT_THAT(in_body("x = on | noplan"), ElementsAre("RMPL0322 p.rmpl:2:10"));
  EXPECT_THAT(in_body("when likely(surprise, 0.5) donext x = on"), ElementsAre("RMPL0322 p.rmpl:2:13"));
  EXPECT_THAT(in_body("when likely(x = on, 0) donext x = on"), ElementsAre("RMPL0200 p.rmpl:2:21"));
  EXPECT_THAT(in_body("when likely(x = on, 1.5) donext x = on"), ElementsAre("RMPL0200 p.rmpl:2:21"));
  EXPECT_THAT(in_body("t = 0; when possible(t > 3 s) donext x = on"), ElementsAre("RMPL0301 p.rmpl:2:22"));
  EXPECT_THAT(errors("p.rmpl", "A(c) :: { when c donext x = on }\nP() :: { A(surprise); A(likely(x = off, 0.9)) }\n"),
              IsEmpty());
  EXPECT_THAT(over_plant("P() :: { when surprise(engine.temp) donext engine = on }"),
              ElementsAre("RMPL0106 p.rmpl:1:24"));
  EXPECT_THAT(over_plant("P() :: { when surprise(motor) donext engine = on }"), ElementsAre("RMPL0308 p.rmpl:1:24"));
}

TEST_F(ProgramErrors, WithoutAPlantAVariableIsNotTakenForAValue) {
  EXPECT_THAT(in_body("y = on; if x = y thennext z = on"), ElementsAre("RMPL0104 p.rmpl:2:16"));
  EXPECT_THAT(in_body("if x != y thennext z = on; y = on"), ElementsAre("RMPL0104 p.rmpl:2:9"));
  EXPECT_THAT(in_body("t = 0; if x = t thennext z = on"), ElementsAre("RMPL0106 p.rmpl:2:15"));
  EXPECT_THAT(in_body("y = on; if x in { y } thennext z = on"), IsEmpty());
  EXPECT_THAT(over_plant("P() :: { if engine.temp = low thennext engine = on }"), IsEmpty());
}

TEST_F(ProgramErrors, NamesOfThePlant) {
  EXPECT_THAT(over_plant("P() :: { engine = on }"), IsEmpty());
  EXPECT_THAT(over_plant("P() :: { motor = on }"), ElementsAre("RMPL0308 p.rmpl:1:10"));
  EXPECT_THAT(over_plant("P() :: { engine = firing }"), ElementsAre("RMPL0102 p.rmpl:1:19"));
  EXPECT_THAT(over_plant("P() :: { engine.temp = high }"), IsEmpty());
  EXPECT_THAT(over_plant("P() :: { engine.temp = warm }"), ElementsAre("RMPL0102 p.rmpl:1:24"));
  EXPECT_THAT(over_plant("P() :: { when engine.tmep = high donext engine = on }"), ElementsAre("RMPL0308 p.rmpl:1:15"));
  EXPECT_THAT(over_plant("P() :: { engine = 0 }"), ElementsAre("RMPL0101 p.rmpl:1:10"));
}

TEST_F(ProgramErrors, ArgumentsAreBlamedWhereTheyArePassed) {
  EXPECT_THAT(over_plant("Open(v) :: { v = on }\nP() :: { Open(engine); Open(motor) }"),
              ElementsAre("RMPL0308 p.rmpl:2:29"));
  EXPECT_THAT(errors("p.rmpl", "A(v) :: { v = on }\nP() :: { A(x = y) }\n"), ElementsAre("RMPL0309 p.rmpl:1:11"));
  EXPECT_THAT(errors("p.rmpl", "A(c) :: { when c donext x = on }\nP() :: { A(y) }\n"),
              ElementsAre("RMPL0309 p.rmpl:1:16"));
}

TEST_F(ProgramErrors, UnusedDefinitionsAreCheckedButForThePlant) {
  EXPECT_THAT(over_plant("P() :: { engine = on }\nQ() :: { motor = on }\n"), ElementsAre("RMPL0306 p.rmpl:2:1"));
  const std::string library = write("library.rmpl", "Q(v) :: { motor = on; false }\n");
  EXPECT_THAT(over_plant("import \"library.rmpl\";\nP() :: { engine = on }\n"),
              ElementsAre("RMPL0323 library.rmpl:1:23"));
}

TEST_F(ProgramErrors, Clocks) {
  EXPECT_THAT(in_body("when t >= 3 s donext x = on"), ElementsAre("RMPL0300 p.rmpl:2:6"));
  EXPECT_THAT(in_body("when t >= 3 s donext { t = 0; x = on }"), ElementsAre("RMPL0300 p.rmpl:2:6"));
  EXPECT_THAT(in_body("t = 0; when t >= 3 s donext x = on"), IsEmpty());
  EXPECT_THAT(in_body("t = 0, when t >= 3 s donext x = on"), IsEmpty());
  EXPECT_THAT(in_body("whenever t >= 3 s donext { t = 0 }"), IsEmpty());
  EXPECT_THAT(in_body("do { t = 0; always x = on } watching t >= 3 s"), IsEmpty());
  EXPECT_THAT(in_body("do always x = on watching t >= 3 s; t = 0"), ElementsAre("RMPL0300 p.rmpl:2:27"));
  EXPECT_THAT(in_body("if x = on thennext t = 0; when t >= 3 s donext y = on"), IsEmpty());
  EXPECT_THAT(errors("p.rmpl", "W(t) :: { when t >= 3 s donext x = on }\nP() :: { u = 0; W(u); W(s) }\n"),
              ElementsAre("RMPL0300 p.rmpl:2:25"));
  EXPECT_THAT(errors("p.rmpl", "W(c) :: { when c donext x = on }\nP() :: { W(t > 1 s) }\n"),
              ElementsAre("RMPL0300 p.rmpl:2:12"));
  // An argument is read where the callee asks for it, after what the callee has started by then.
  EXPECT_THAT(errors("p.rmpl", "W(c) :: { t = 0; when c donext x = on }\nP() :: { W(t > 1 s) }\n"), IsEmpty());
  EXPECT_THAT(errors("p.rmpl", "W(c) :: { when c donext x = on; t = 0 }\nP() :: { W(t > 1 s) }\n"),
              ElementsAre("RMPL0300 p.rmpl:2:12"));
  EXPECT_THAT(
      errors("p.rmpl", "V(c) :: { when c donext x = on }\nW(c, u) :: { u = 0; V(c) }\nP() :: { W(t > 1 s, t) }\n"),
      IsEmpty());
  EXPECT_THAT(errors("p.rmpl", "S(t) :: { t = 0 }\nP() :: { S(u); when u > 1 s donext x = on }\n"), IsEmpty());
  EXPECT_THAT(errors("p.rmpl", "P() :: { if x = on thennext { when t > 1 s donext { t = 0; P() } } }\n"), IsEmpty());
}

TEST_F(ProgramErrors, OwnClocks) {
  EXPECT_THAT(errors("p.rmpl", "P() :: { t = 0; Q() } Q() :: { clock t; when t > 1 s donext x = on }"),
              ElementsAre("RMPL0300 p.rmpl:1:46"));
  EXPECT_THAT(errors("p.rmpl", "P() :: { Q(); when t > 1 s donext x = on } Q() :: { clock t; t = 0 }"),
              ElementsAre("RMPL0300 p.rmpl:1:20"));
  EXPECT_THAT(errors("p.rmpl", "P() :: { clock t; next { when t > 1 s donext t = 0 } }"),
              ElementsAre("RMPL0300 p.rmpl:1:31"));
  EXPECT_THAT(errors("p.rmpl", "P() :: { clock t, t; t = 0 }"), ElementsAre("RMPL0101 p.rmpl:1:19"));
  EXPECT_THAT(errors("p.rmpl", "P() :: { Q(y) } Q(t) :: { clock t; t = 0 }"), ElementsAre("RMPL0101 p.rmpl:1:33"));
  EXPECT_THAT(errors("p.rmpl", "P() :: { clock t; t = 0; when t = on donext x = on }"),
              ElementsAre("RMPL0106 p.rmpl:1:31"));
}

TEST_F(ProgramErrors, OneMistakeOneError) {
  EXPECT_THAT(errors("p.rmpl", "P() :: { R(); R(); when t > 1 s donext x = on } Q() :: { x = on }"),
              ElementsAre("RMPL0100 p.rmpl:1:10"));
}

TEST_F(ProgramErrors, Recursion) {
  EXPECT_THAT(errors("p.rmpl", "P() :: { P() }\n"), ElementsAre("RMPL0302 p.rmpl:1:10"));
  EXPECT_THAT(errors("p.rmpl", "P() :: { P(); x = on }\n"), ElementsAre("RMPL0303 p.rmpl:1:10"));
  EXPECT_THAT(errors("p.rmpl", "P() :: { x = on, P() }\n"), ElementsAre("RMPL0303 p.rmpl:1:18"));
  EXPECT_THAT(errors("p.rmpl", "P() :: { do { x = on; P() } watching y = on }\n"), ElementsAre("RMPL0303 p.rmpl:1:23"));
  EXPECT_THAT(errors("p.rmpl", "P() :: { always P() }\n"), ElementsAre("RMPL0303 p.rmpl:1:17"));
  EXPECT_THAT(errors("p.rmpl", "P() :: { x = on; P() }\n"), IsEmpty());
  EXPECT_THAT(errors("p.rmpl", "P() :: { if x = on thennext P() elsenext { y = on; P() } }\n"), IsEmpty());
}

TEST_F(ProgramErrors, RecursionNamesTheCycle) {
  const Compilation nested =
      compile_text("p.rmpl", "P() :: { A() }\nA() :: { x = on; B() }\nB() :: { do A() watching y = on }\n");
  EXPECT_THAT(findings(nested), ElementsAre("RMPL0303 p.rmpl:3:13"));
  EXPECT_THAT(messages(nested), ElementsAre(HasSubstr("`B` -> `A` -> `B`")));
  EXPECT_THAT(notes(nested), ElementsAre("p.rmpl:2:18"));
  const Compilation unguarded = compile_text("p.rmpl", "P() :: { A() }\nA() :: { B() }\nB() :: { A() }\n");
  EXPECT_THAT(findings(unguarded), ElementsAre("RMPL0302 p.rmpl:2:10"));
  EXPECT_THAT(messages(unguarded), ElementsAre(HasSubstr("`A` -> `B` -> `A`")));
}

TEST_F(ProgramErrors, ModelProgramsAreNoControlPrograms) {
  EXPECT_THAT(in_body("choose { x = on with 0.5, x = off with 0.5 }"), ElementsAre("RMPL0310 p.rmpl:2:1"));
  EXPECT_THAT(errors("p.rmpl", "variable x : { on, off };\nP() :: { x = on }\n"), ElementsAre("RMPL0310 p.rmpl:1:1"));
}

TEST_F(ProgramErrors, CallsThatMultiplyEndInAnError) {
  std::string text = "D0() :: { x = on }\n";
  for (int i = 1; i < 40; ++i) {
    const std::string call = "D" + std::to_string(i - 1) + "()";
    text += "D" + std::to_string(i) + "() :: { " + call + "; " + call + "; " + call + " }\n";
  }
  const auto found = errors("p.rmpl", text);
  ASSERT_FALSE(found.empty());
  EXPECT_THAT(found.front(), HasSubstr("RMPL0010"));
}

TEST_F(ProgramErrors, CallsThatNestWithoutEndEndInAnError) {
  std::string text;
  for (int i = 0; i < 20000; ++i) {
    text += "D" + std::to_string(i) + "() :: { D" + std::to_string(i + 1) + "() }\n";
  }
  const auto found = errors("p.rmpl", text + "D20000() :: { x = on }\n");
  ASSERT_FALSE(found.empty());
  EXPECT_THAT(found.front(), HasSubstr("RMPL0003"));
}

TEST_F(ProgramErrors, RecursionThatGrowsItsArgumentsEndsInAnError) {
  EXPECT_THAT(errors("p.rmpl", "A(c) :: { when c donext A(c & x = on) }\nP() :: { A(y = on) }\n"),
              ElementsAre(HasSubstr("RMPL0003")));
}

}  // namespace
}  // namespace rmpl::compiler
