// Every error of a model program, with its code and place.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "tests/unit/compiler/workspace.hpp"

namespace rmpl::compiler {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ModelErrors : public Workspace {
 protected:
  std::vector<std::string> of(const std::string& text) {
    return errors("m.rmpl", "variable x, y : { a, b };\n" + text);
  }
  /// The findings in a body on line 2, which begins in column 16.
  std::vector<std::string> in_body(const std::string& body) { return of("model P() :: { " + body + " }"); }
};

TEST_F(ModelErrors, BranchesThatTellAtOnce) {
  const Strings told{"RMPL0315 m.rmpl:2:32"};
  EXPECT_EQ(in_body("always choose { x = a with 0.5, next x = b with 0.5 }"), told);
  EXPECT_THAT(in_body("always choose { { next x = a, do { y = a; x = b } watching x = b } with 1 }"),
              ElementsAre("RMPL0315 m.rmpl:2:51"));
  EXPECT_THAT(in_body("next choose { choose { x = a with 1 } with 0.5, { true; x = b } with 0.5 }"),
              ElementsAre("RMPL0315 m.rmpl:2:39"));
  EXPECT_THAT(in_body("choose { x = a with 0.5, x = b with 0.5 }"), IsEmpty());
  EXPECT_THAT(suggestions(compile_text("m.rmpl", "variable x : { a }; model P() :: { next choose { x = a with 1 } }")),
              ElementsAre("tell it in the next instant: `next x = a`"));
  // Where a call leads back to it, it is drawn as its instant ends, each time.
  EXPECT_THAT(of("model P() :: { choose { x = a with 1 }; next P() }"), ElementsAre("RMPL0315 m.rmpl:2:25"));
}

TEST_F(ModelErrors, Probabilities) {
  EXPECT_THAT(in_body("choose { x = a with 0.5, x = b with 0.4 }"), ElementsAre("RMPL0316 m.rmpl:2:16"));
  EXPECT_THAT(in_body("choose { x = a with 0.5, x = b with 0.6 }"), ElementsAre("RMPL0201 m.rmpl:2:16"));
  EXPECT_THAT(in_body("choose { x = a with 1.5, x = b with 0.6 }"), ElementsAre("RMPL0200 m.rmpl:2:36"));
  EXPECT_THAT(in_body("choose { x = a with 2, x = b with 1 }"), IsEmpty());
}

TEST_F(ModelErrors, ModelAndControlDefinitions) {
  EXPECT_THAT(of("model P() :: { Q() }\nQ() :: { x = a }"), ElementsAre("RMPL0314 m.rmpl:2:16"));
  EXPECT_THAT(of("model P() :: { x = a }\nQ() :: { P() }"), ElementsAre("RMPL0314 m.rmpl:3:10"));
  EXPECT_THAT(of("model P() :: { x = a }\nQ() :: { x = a }"), ElementsAre("RMPL0314 m.rmpl:3:1"));
  const std::string model = write("model.rmpl", "variable x : { a }; model P() :: { x = a }");
  EXPECT_THAT(errors("main.rmpl", "import \"model.rmpl\";\nMain() :: { P() }"), ElementsAre("RMPL0314 main.rmpl:2:13"));
  EXPECT_THAT(errors("p.rmpl", "variable x : { a };\nconstraint x = a;\nMain() :: { x = a }"),
              ElementsAre("RMPL0310 p.rmpl:1:1", "RMPL0310 p.rmpl:2:1"));
  EXPECT_THAT(errors("p.rmpl", "variable x : { a };"), ElementsAre("RMPL0312 p.rmpl:1:1"));
}

TEST_F(ModelErrors, Recursion) {
  EXPECT_THAT(of("model P() :: { P() }"), ElementsAre("RMPL0302 m.rmpl:2:16"));
  EXPECT_THAT(of("model M() :: { P() } model P() :: { x = a, P() }"), ElementsAre("RMPL0302 m.rmpl:2:44"));
  EXPECT_THAT(of("model M() :: { P() } model P() :: { choose { P() with 1 } }"), ElementsAre("RMPL0302 m.rmpl:2:46"));
  EXPECT_THAT(of("model M() :: { P() } model P() :: { x = a, Q() } model Q() :: { Q(), P() }"),
              ElementsAre("RMPL0302 m.rmpl:2:44", "RMPL0302 m.rmpl:2:65"));
  EXPECT_THAT(of("model M() :: { P() } model P() :: { next P(); x = a }"), ElementsAre("RMPL0303 m.rmpl:2:42"));
  EXPECT_THAT(of("model M() :: { P() } model P() :: { do next P() watching x = a }"),
              ElementsAre("RMPL0303 m.rmpl:2:45"));
  EXPECT_THAT(of("model M() :: { P() } model P() :: { always next P() }"), ElementsAre("RMPL0303 m.rmpl:2:49"));
  EXPECT_THAT(of("model M() :: { P() } model P() :: { { x = a, next P() }; y = a }"),
              ElementsAre("RMPL0303 m.rmpl:2:51"));
}

TEST_F(ModelErrors, Clocks) {
  EXPECT_THAT(in_body("t = 0; when t > 1 s donext x = a"), ElementsAre("RMPL0317 m.rmpl:2:16", "RMPL0317 m.rmpl:2:28"));
  EXPECT_THAT(in_body("clock t; x = a"), ElementsAre("RMPL0317 m.rmpl:2:22"));
  EXPECT_THAT(of("constraint t > 1 s; model P() :: { x = a }"), ElementsAre("RMPL0317 m.rmpl:2:12"));
}

TEST_F(ModelErrors, NamesAndValues) {
  EXPECT_THAT(in_body("z = a"), ElementsAre("RMPL0100 m.rmpl:2:16"));
  EXPECT_THAT(in_body("x = c"), ElementsAre("RMPL0102 m.rmpl:2:20"));
  EXPECT_THAT(in_body("if z = a thennext x = a"), ElementsAre("RMPL0100 m.rmpl:2:19"));
  EXPECT_THAT(of("observe z; control z; control x default c; model P() :: { x = a }"),
              ElementsAre("RMPL0100 m.rmpl:2:9", "RMPL0100 m.rmpl:2:20", "RMPL0102 m.rmpl:2:41"));
  EXPECT_THAT(of("observe x, x; model P() :: { x = a }"), ElementsAre("RMPL0101 m.rmpl:2:12"));
  EXPECT_THAT(of("variable x : { a }; constraint y = c; model P() :: { x = a }"),
              ElementsAre("RMPL0101 m.rmpl:2:10", "RMPL0102 m.rmpl:2:36"));
  EXPECT_THAT(of("variable v : Level; observe v; model P() :: { v = a }"), ElementsAre("RMPL0100 m.rmpl:2:14"));
  EXPECT_THAT(messages(compile_text("m.rmpl", "variable x : { a }; model P() :: { z = a }")),
              ElementsAre("the model program has no variable `z`"));
}

TEST_F(ModelErrors, AScenarioFliesNoModelProgram) {
  write("m.rmpl", "variable x : { a }; model P() :: { x = a }");
  write("p.tcca", "component C { initial a; mode a; } plant P { c : C; }");
  const Compilation result = compile_text("s.scn", "scenario \"s\" {\n  program \"m.rmpl\";\n  plant \"p.tcca\";\n}");
  EXPECT_THAT(findings(result), ElementsAre("RMPL0312 s.scn:2:11"));
  EXPECT_THAT(messages(result), ElementsAre(HasSubstr("is a model program")));
}

TEST_F(ModelErrors, ManyThreadsInABranchAreNoProduct) {
  std::string threads = "next x = a";
  for (int t = 0; t < 3000; ++t) threads += ", next y = b";
  EXPECT_THAT(
      in_body("next choose { { choose { next x = a with 0.5, next x = b with 0.5 }, " + threads + " } with 1 }"),
      IsEmpty());
}

TEST_F(ModelErrors, ChoicesThatMultiplyWithoutBounds) {
  std::string threads;
  for (int t = 0; t < 24; ++t)
    threads += std::string(t == 0 ? "" : ", ") + "choose { next x = a with 1, next x = b with 1, true with 2 }";
  EXPECT_THAT(in_body("next choose { { " + threads + " } with 1 }"), ElementsAre("RMPL0010 m.rmpl:2:32"));
}

}  // namespace
}  // namespace rmpl::compiler
