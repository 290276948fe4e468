// Every error of a plant model, with its code and place.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "tests/unit/compiler/workspace.hpp"

namespace rmpl::compiler {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class PlantErrors : public Workspace {
 protected:
  /// A component of one line, in a plant that has an instance of it.
  std::vector<std::string> in_component(const std::string& line) {
    return errors("p.tcca", "component C { input a : { x, y }; mode m; mode n; fault f; fault g; initial m;\n" + line +
                                "\n}\nplant P { c : C; }\n");
  }
  /// One line of a plant with two instances.
  std::vector<std::string> in_plant(const std::string& line) {
    return errors(
        "p.tcca",
        "component C { input a : { x, y }; input b : { u, v }; mode m; initial m; }\nplant P { c : C; d : C;\n" + line +
            "\n}\n");
  }
};

TEST_F(PlantErrors, NoneInAGoodModel) {
  EXPECT_THAT(in_component("m -> n when a = x; any -> f with 0.1;"), IsEmpty());
  EXPECT_THAT(in_plant("c.a = d.a; control c.a default x; observe d.a, d.b;"), IsEmpty());
}

TEST_F(PlantErrors, DoubleNames) {
  EXPECT_THAT(in_component("mode m;"), ElementsAre("RMPL0101 p.tcca:2:6"));
  EXPECT_THAT(in_component("output a : { x };"), ElementsAre("RMPL0101 p.tcca:2:8"));
  EXPECT_THAT(in_component("output z : { x, x };"), ElementsAre("RMPL0101 p.tcca:2:17"));
  EXPECT_THAT(in_component("initial n;"), ElementsAre("RMPL0101 p.tcca:2:1"));
  EXPECT_THAT(in_plant("c : C;"), ElementsAre("RMPL0101 p.tcca:3:1"));
  EXPECT_THAT(in_plant("input d : { x };"), ElementsAre("RMPL0101 p.tcca:2:18"));
  EXPECT_THAT(in_plant("observe c.a; observe c.a;"), ElementsAre("RMPL0101 p.tcca:3:22"));
  EXPECT_THAT(errors("p.tcca",
                     "domain D = { x };\ndomain D = { y };\ncomponent C { mode m; initial m; }\nmodule C { }\n"
                     "plant P { c : C; }\n"),
              ElementsAre("RMPL0101 p.tcca:2:8", "RMPL0101 p.tcca:4:8"));
}

TEST_F(PlantErrors, NoteShowsTheFirstDefinition) {
  const Compilation result =
      compile_text("p.tcca", "component C { mode m;\nmode m; initial m; }\nplant P { c : C; }\n");
  EXPECT_THAT(notes(result), ElementsAre("p.tcca:1:20"));
}

TEST_F(PlantErrors, UnknownNames) {
  EXPECT_THAT(in_component("m -> o when a = x;"), ElementsAre("RMPL0100 p.tcca:2:6"));
  EXPECT_THAT(in_component("o -> m when a = x;"), ElementsAre("RMPL0100 p.tcca:2:1"));
  EXPECT_THAT(in_component("m -> n when q = x;"), ElementsAre("RMPL0100 p.tcca:2:13"));
  EXPECT_THAT(in_component("input q : Level;"), ElementsAre("RMPL0100 p.tcca:2:11"));
  EXPECT_THAT(in_plant("e : Valve;"), ElementsAre("RMPL0100 p.tcca:3:5"));
  EXPECT_THAT(in_plant("c.a = e.a;"), ElementsAre("RMPL0102 p.tcca:3:7"));
  EXPECT_THAT(in_plant("observe c.q;"), ElementsAre("RMPL0100 p.tcca:3:9"));
}

TEST_F(PlantErrors, NearestNameIsSuggested) {
  const Compilation result =
      compile_text("p.tcca", "component Valve { mode closed; initial close; }\nplant P { v : Vavle; }\n");
  EXPECT_THAT(findings(result), ElementsAre("RMPL0100 p.tcca:1:40", "RMPL0100 p.tcca:2:15"));
  EXPECT_THAT(suggestions(result), ElementsAre("did you mean `closed`?", "did you mean `Valve`?"));
}

TEST_F(PlantErrors, ValuesAndDomains) {
  EXPECT_THAT(in_component("m -> n when a = z;"), ElementsAre("RMPL0102 p.tcca:2:17"));
  EXPECT_THAT(in_component("m -> n when a in { x, z };"), ElementsAre("RMPL0102 p.tcca:2:23"));
  EXPECT_THAT(in_plant("c.a = c.b;"), ElementsAre("RMPL0103 p.tcca:3:1"));
  EXPECT_THAT(in_plant("c = n;"), ElementsAre("RMPL0102 p.tcca:3:5"));
  EXPECT_THAT(in_component("input x : { x, y }; m -> n when a = x;"), ElementsAre("RMPL0104 p.tcca:2:37"));
  EXPECT_THAT(in_component("m -> n when a;"), ElementsAre("RMPL0106 p.tcca:2:13"));
}

TEST_F(PlantErrors, NoteShowsTheDomain) {
  const Compilation result = compile_text(
      "p.tcca",
      "domain D = { x, y };\ncomponent C { input a : D; mode m { a = z }; initial m; }\nplant P { c : C; }\n");
  EXPECT_THAT(notes(result), ElementsAre("p.tcca:1:12"));
}

TEST_F(PlantErrors, Probabilities) {
  EXPECT_THAT(in_component("m -> f with 1.5;"), ElementsAre("RMPL0200 p.tcca:2:13"));
  EXPECT_THAT(in_component("any -> f with 0.6; any -> g with 0.6;"),
              ElementsAre("RMPL0201 p.tcca:2:27", "RMPL0201 p.tcca:2:27"));
  EXPECT_THAT(in_component("m -> { n with 0.9, m with 0.3 };"), ElementsAre("RMPL0201 p.tcca:2:8"));
  EXPECT_THAT(in_component("m -> { n with 0.6, m with 0.3 };"), ElementsAre("RMPL0218 p.tcca:2:8"));
  EXPECT_THAT(in_component("m -> { n with 3, m with 1 };"), IsEmpty());
  EXPECT_THAT(in_component("m -> { n with 0.5, m with 2 };"), IsEmpty());
  EXPECT_THAT(in_component("m -> { n with 1.5, m with 0.5 };"), ElementsAre("RMPL0200 p.tcca:2:15"));
  EXPECT_THAT(in_component("m -> n when a = x; m -> n when a = y; m, n -> n when a = x;"),
              ElementsAre("RMPL0500 p.tcca:2:47"));
  EXPECT_THAT(errors("p.tcca", "component C { mode m; mode n; initial m 0.9, n 0.9; }\nplant P { c : C; }\n"),
              ElementsAre("RMPL0201 p.tcca:1:31"));
  EXPECT_THAT(errors("p.tcca", "component C { mode m; mode n; initial m 0.1, n 0.2; }\nplant P { c : C; }\n"),
              ElementsAre("RMPL0214 p.tcca:1:31"));
  EXPECT_THAT(errors("p.tcca", "component C { mode m; }\nplant P { c : C; }\n"), ElementsAre("RMPL0214 p.tcca:1:11"));
  EXPECT_THAT(in_component("m -> f with rate -1 /h;"), ElementsAre("RMPL0217 p.tcca:2:18"));
  EXPECT_THAT(in_component("m -> f;"), ElementsAre("RMPL0204 p.tcca:2:6"));
  EXPECT_THAT(in_component("m -> n with rate 1 /h;"), ElementsAre("RMPL0212 p.tcca:2:18"));
}

TEST_F(PlantErrors, FaultsThatExcludeEachOtherMaySumAboveOne) {
  EXPECT_THAT(in_component("m -> f when a = x with 0.6; m -> g when a = y with 0.6;"), IsEmpty());
  EXPECT_THAT(in_component("m -> f when a = x with 0.6; m -> g when a != y with 0.6;"),
              ElementsAre("RMPL0201 p.tcca:2:34"));
}

TEST_F(PlantErrors, TimeBounds) {
  EXPECT_THAT(in_component("m -> n in [60 s, 30 s];"), ElementsAre("RMPL0202 p.tcca:2:12"));
  EXPECT_THAT(in_component("m -> n in [60 s, inf];"), ElementsAre("RMPL0203 p.tcca:2:8"));
  EXPECT_THAT(in_component("m -> { n with 0.9, f with 0.1 } in [60 s, inf];"), ElementsAre("RMPL0203 p.tcca:2:33"));
  EXPECT_THAT(in_component("m -> f in [60 s, inf] with rate 1 /h;"), IsEmpty());
  EXPECT_THAT(in_component("m -> n in [60 s, inf] ~ exponential(0 s);"), ElementsAre("RMPL0213 p.tcca:2:37"));
  EXPECT_THAT(in_component("m -> n in [60 s, inf] ~ normal(60 s, 0 s);"), ElementsAre("RMPL0213 p.tcca:2:38"));
  EXPECT_THAT(in_component("m -> n in [0, inf] ~ weibull(0, 60 s);"), ElementsAre("RMPL0213 p.tcca:2:30"));
  EXPECT_THAT(in_component("m -> n in [0, inf] ~ weibull(2, 0 s);"), ElementsAre("RMPL0213 p.tcca:2:33"));
  EXPECT_THAT(in_component("m -> n in [0, inf] ~ erlang(1.5, 60 s);"), ElementsAre("RMPL0213 p.tcca:2:29"));
  EXPECT_THAT(in_component("m -> n in [0, inf] ~ erlang(101, 60 s);"), ElementsAre("RMPL0213 p.tcca:2:29"));
  EXPECT_THAT(in_component("m -> n in [0, inf] ~ erlang(3, 60 s);"), IsEmpty());
  EXPECT_THAT(in_component("m -> n after 0.1e-9 s;"), ElementsAre("RMPL0005 p.tcca:2:14"));
  EXPECT_THAT(in_component("m -> n when t > 30 s;"), ElementsAre("RMPL0206 p.tcca:2:13"));
}

TEST_F(PlantErrors, GuardsSpeakOfOwnAttributes) {
  EXPECT_THAT(in_component("m -> n when d.a = x;"), ElementsAre("RMPL0205 p.tcca:2:13"));
  EXPECT_THAT(in_component("mode o { d.a = x };"), ElementsAre("RMPL0205 p.tcca:2:10"));
}

TEST_F(PlantErrors, PlantsAndModules) {
  EXPECT_THAT(errors("p.tcca", "component C { mode m; initial m; }\n"), ElementsAre("RMPL0207 p.tcca:1:1"));
  EXPECT_THAT(errors("p.tcca", "component C { mode m; initial m; }\nplant P { c : C; }\nplant Q { c : C; }\n"),
              ElementsAre("RMPL0208 p.tcca:3:7"));
  EXPECT_THAT(errors("p.tcca", "plant P { }\n"), ElementsAre("RMPL0209 p.tcca:1:7"));
  EXPECT_THAT(errors("p.tcca", "component C { input a : { x }; }\nplant P { c : C; }\n"),
              ElementsAre("RMPL0211 p.tcca:1:11"));
  EXPECT_THAT(in_plant("e : P;"), ElementsAre("RMPL0106 p.tcca:3:5"));
  EXPECT_THAT(in_plant("observe c;"), ElementsAre("RMPL0106 p.tcca:3:9"));
  EXPECT_THAT(in_plant("control c.a;"), ElementsAre("RMPL0215 p.tcca:3:1"));
  EXPECT_THAT(in_plant("control c.a default u;"), ElementsAre("RMPL0102 p.tcca:3:21"));
}

TEST_F(PlantErrors, ModulesThatContainThemselves) {
  const Compilation result =
      compile_text("p.tcca",
                   "module A { b : B; }\nmodule B { a : A; }\ncomponent C { mode m; initial m; }\n"
                   "plant P { a : A; c : C; }\n");
  EXPECT_THAT(findings(result), ElementsAre("RMPL0210 p.tcca:2:16"));
  EXPECT_THAT(messages(result), ElementsAre(HasSubstr("`A` -> `B` -> `A`")));
}

TEST_F(PlantErrors, ModulesThatMultiplyEndInAnError) {
  std::string text = "component C { mode m; initial m; }\nmodule M0 { a, b, c, d : C; }\n";
  for (int i = 1; i < 20; ++i) {
    text += "module M" + std::to_string(i) + " { a, b, c, d : M" + std::to_string(i - 1) + "; }\n";
  }
  const auto found = errors("p.tcca", text + "plant P { m : M19; }\n");
  ASSERT_FALSE(found.empty());
  EXPECT_THAT(found.front(), HasSubstr("RMPL0010"));
}

TEST_F(PlantErrors, NothingMoreIsSaidOfWhatHasNoRoom) {
  std::string text = "component C { output x : { p, q }; mode m; initial m; }\nmodule M0 { c : C; }\n";
  for (int i = 1; i < 20; ++i) {
    text += "module M" + std::to_string(i) + " { a, b : M" + std::to_string(i - 1) + "; }\n";
  }
  const auto found = errors("p.tcca", text + "plant P { m, n : M19; o : M19; o.a.b.c.x = n.b.c.x; observe o.c.x; }\n");
  EXPECT_THAT(found, ElementsAre(HasSubstr("RMPL0010")));
}

TEST_F(PlantErrors, AreCollected) {
  EXPECT_THAT(
      in_component("m -> o; m -> f; m -> n when q = x in [2 s, 1 s];"),
      ElementsAre("RMPL0100 p.tcca:2:6", "RMPL0204 p.tcca:2:14", "RMPL0100 p.tcca:2:29", "RMPL0202 p.tcca:2:39"));
}

}  // namespace
}  // namespace rmpl::compiler
