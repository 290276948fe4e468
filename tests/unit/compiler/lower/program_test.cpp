// Every construct of the table in semantics 2, the twelve locations of Fig. 3-4, parameters and tail calls.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "grammar/source/render.hpp"
#include "tests/paths.hpp"
#include "tests/unit/compiler/workspace.hpp"

namespace rmpl::compiler {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string text(const automata::Condition& condition, const automata::Program& program) {
  if (condition.is_trivial()) return "";
  return (condition.entailed ? "" : "not-entailed ") + to_text(condition.constraint, program.variables, program.clocks);
}

/// `4 [1*] when t1 >= 16200 s: not-entailed t1 >= 16200 s -> 4; t1 >= 16200 s -> 5`: number, parent (with a star for a
/// start location), label, maintenance, arcs.
std::vector<std::string> lines(const automata::Program& program) {
  std::vector<std::string> result;
  for (std::size_t l = 0; l < program.locations.size(); ++l) {
    const automata::Location& location = program.locations[l];
    std::string line = std::to_string(l + 1);
    if (location.parent) line += " [" + std::to_string(location.parent->value + 1) + (location.start ? "*]" : "]");
    line += location.composite ? " (" + location.label + ")" : " " + location.label;
    if (!location.maintenance.is_trivial()) line += " maintains " + text(location.maintenance, program);
    std::string separator = ":";
    for (const automata::Arc& arc : location.arcs) {
      const std::string guard = text(arc.guard, program);
      line += separator + (guard.empty() ? "" : " " + guard) + " -> " + std::to_string(arc.target.value + 1);
      separator = ";";
    }
    result.push_back(line);
  }
  return result;
}

class Programs : public Workspace {
 protected:
  std::vector<std::string> of(const std::string& source) {
    const Compilation result = compile_text("p.rmpl", source);
    EXPECT_THAT(grammar::render_text(result.findings(), false), IsEmpty());
    return result.ok() ? lines(result.document().programs.at(0)) : Strings{};
  }
  std::vector<std::string> body(const std::string& source) { return of("P() :: { " + source + " }"); }
};

TEST_F(Programs, EachCallHasClocksOfItsOwn) {
  const Compilation result = compile_text(
      "p.rmpl",
      "P() :: { Q(); Q() } Q() :: { clock t; t = 0; when t > 1 s donext R(t) } R(u) :: { when u > 2 s donext x = on }");
  ASSERT_TRUE(result.ok());
  const automata::Program& program = result.document().programs.at(0);
  EXPECT_THAT(program.clocks, ElementsAre("t@2", "t@8"));
  EXPECT_THAT(program.locations.at(1).own_clocks, ElementsAre(automata::ClockId(std::size_t{0})));
  EXPECT_THAT(program.locations.at(7).own_clocks, ElementsAre(automata::ClockId(std::size_t{1})));
  EXPECT_EQ(program.locations.at(10).label, "R(t@8)");
}

TEST_F(Programs, ATailCallEntersWhatHasClocksAnew) {
  EXPECT_THAT(body("clock t; t = 0; when t > 1 s donext P()"),
              ElementsAre("1 (P())", "2 [1*] t@1 = 0: -> 3",
                          "3 [1] when t@1 > 1 s: not-entailed t@1 > 1 s -> 3; t@1 > 1 s -> 1"));
}

TEST_F(Programs, MarsEntryHasTheTwelveLocationsOfTheThesis) {
  const Compilation result = compile_files({rmpl::paths::source() + "/tests/unit/grammar/listings/fig_b_2.rmpl"});
  ASSERT_TRUE(result.ok());
  const automata::Program& program = result.document().programs.at(0);
  EXPECT_THAT(lines(program),
              ElementsAre("1 (EntrySequence())", "2 [1*] engine = standby: -> 3", "3 [1] t1 = 0: -> 4",
                          "4 [1] when t1 >= 16200 s: not-entailed t1 >= 16200 s -> 4; t1 >= 16200 s -> 5",
                          "5 [1] nav = inertial: -> 6", "6 [1] t2 = 0: -> 7",
                          "7 [1] when t2 >= 240 s: not-entailed t2 >= 240 s -> 7; t2 >= 240 s -> 8",
                          "8 [1] (do … watching entry = initiated) maintains not-entailed entry = initiated",
                          "9 [8*] always: -> 9; -> 10", "10 [8*] att = entry-orient",
                          "11 [8*] when att = entry-orient: not-entailed att = entry-orient -> 11; att = "
                          "entry-orient -> 12",
                          "12 [8] lander = separated"));
  EXPECT_THAT(program.clocks, ElementsAre("t1", "t2"));
  EXPECT_EQ(program.locations[4].origin.line, 5u);
  EXPECT_EQ(program.locations[4].goal.size(), 1u);
  EXPECT_EQ(program.locations[2].clock_start, automata::ClockId(0));
}

TEST_F(Programs, Sequence) {
  EXPECT_THAT(body("a = x; b = y;"), ElementsAre("1 (P())", "2 [1*] a = x: -> 3", "3 [1] b = y"));
}

TEST_F(Programs, ParallelThatIsTheWholeBody) {
  EXPECT_THAT(body("a = x, b = y"), ElementsAre("1 (P())", "2 [1*] a = x", "3 [1*] b = y"));
  EXPECT_THAT(body("{ { a = x, b = y } }"), ElementsAre("1 (P())", "2 [1*] a = x", "3 [1*] b = y"));
}

TEST_F(Programs, ParallelInASequenceIsComposite) {
  EXPECT_THAT(body("{ a = x, b = y }; c = z"),
              ElementsAre("1 (P())", "2 [1*] ({ … , … }): -> 5", "3 [2*] a = x", "4 [2*] b = y", "5 [1] c = z"));
}

TEST_F(Programs, SemicolonBindsTighterThanComma) {
  EXPECT_THAT(body("a = x; b = y, c = z"), ElementsAre("1 (P())", "2 [1*] a = x: -> 3", "3 [1] b = y", "4 [1*] c = z"));
}

TEST_F(Programs, GoalsAreConjunctions) {
  const Compilation result = compile_text("p.rmpl", "P() :: { (a = x & b = y); true }");
  ASSERT_TRUE(result.ok());
  const automata::Program& program = result.document().programs.at(0);
  EXPECT_THAT(lines(program), ElementsAre("1 (P())", "2 [1*] a = x & b = y: -> 3", "3 [1] true"));
  EXPECT_EQ(program.locations[1].goal.size(), 2u);
  EXPECT_THAT(program.locations[2].goal, IsEmpty());
}

TEST_F(Programs, GoalsAreAnyConstraint) {
  const Compilation result = compile_text("p.rmpl", "P() :: { a = x & (b = y | c = z) & d != w }");
  ASSERT_TRUE(result.ok());
  const automata::Program& program = result.document().programs.at(0);
  EXPECT_THAT(lines(program), ElementsAre("1 (P())", "2 [1*] a = x & (b = y | c = z) & !d = w"));
  EXPECT_EQ(program.locations[1].goal.size(), 1u);
  EXPECT_EQ(program.locations[1].goal_constraints.size(), 2u);
}

TEST_F(Programs, RepeatLeadsBackFromEveryEnd) {
  EXPECT_THAT(body("repeat { a = x; b = y }"), ElementsAre("1 (P())", "2 [1*] a = x: -> 3", "3 [1] b = y: -> 2"));
  EXPECT_THAT(body("repeat when c = v donext a = x"),
              ElementsAre("1 (P())", "2 [1*] when c = v: not-entailed c = v -> 2; c = v -> 3", "3 [1] a = x: -> 2"));
  EXPECT_THAT(body("repeat if c = v thennext a = x"),
              ElementsAre("1 (P())", "2 [1*] if c = v: c = v -> 3; not-entailed c = v -> 2", "3 [1] a = x: -> 2"));
}

TEST_F(Programs, TheEmptyStepTakesACycle) {
  EXPECT_THAT(body("{ }; a = x"), ElementsAre("1 (P())", "2 [1*] { }: -> 3", "3 [1] a = x"));
}

TEST_F(Programs, BranchesOfEachStandApart) {
  const Compilation result = compile_text("p.rmpl", "P() :: { each { a = x, b = y; c = z }; d = w }");
  ASSERT_TRUE(result.ok());
  const automata::Program& program = result.document().programs.at(0);
  EXPECT_THAT(lines(program),
              ElementsAre("1 (P())", "2 [1*] (each { … }): -> 8", "3 [2*] (branch of each)", "4 [3*] a = x",
                          "5 [2*] (branch of each)", "6 [5*] b = y: -> 7", "7 [5] c = z", "8 [1] d = w"));
  EXPECT_EQ(automata::goal_parts_of(program), (std::vector<std::size_t>{0, 0, 1, 1, 2, 2, 2, 0}));
}

TEST_F(Programs, ConditionsOnKnowledge) {
  EXPECT_THAT(
      body("when surprise & !likely(c = v, 0.95) donext a = x"),
      ElementsAre("1 (P())",
                  "2 [1*] when surprise & !likely(c = v, 0.95): not-entailed surprise & !likely(c = v, 0.95) -> 2; "
                  "surprise & !likely(c = v, 0.95) -> 3",
                  "3 [1] a = x"));
  EXPECT_THAT(
      body("if noplan(a) | possible(c = v, 0.001) thennext a = x"),
      ElementsAre("1 (P())", "2 [1*] if noplan(a) | possible(c = v): noplan(a) | possible(c = v) -> 3", "3 [1] a = x"));
}

TEST_F(Programs, IfThenNext) {
  EXPECT_THAT(body("if c = v thennext a = x; b = y"),
              ElementsAre("1 (P())", "2 [1*] if c = v: c = v -> 3; not-entailed c = v -> 4", "3 [1] a = x: -> 4",
                          "4 [1] b = y"));
}

TEST_F(Programs, IfElseNext) {
  EXPECT_THAT(body("if c = v thennext a = x elsenext b = y; d = z"),
              ElementsAre("1 (P())", "2 [1*] if c = v: c = v -> 3; not-entailed c = v -> 4", "3 [1] a = x: -> 5",
                          "4 [1] b = y: -> 5", "5 [1] d = z"));
}

TEST_F(Programs, Unless) {
  EXPECT_THAT(body("unless c = v thennext a = x; b = y"),
              ElementsAre("1 (P())", "2 [1*] unless c = v: not-entailed c = v -> 3; c = v -> 4", "3 [1] a = x: -> 4",
                          "4 [1] b = y"));
}

TEST_F(Programs, When) {
  EXPECT_THAT(body("when c = v donext a = x; b = y"),
              ElementsAre("1 (P())", "2 [1*] when c = v: not-entailed c = v -> 2; c = v -> 3", "3 [1] a = x: -> 4",
                          "4 [1] b = y"));
}

TEST_F(Programs, WheneverNeverEnds) {
  EXPECT_THAT(body("whenever c = v donext a = x; b = y"),
              ElementsAre("1 (P())", "2 [1*] whenever c = v: -> 2; c = v -> 3", "3 [1] a = x", "4 [1] b = y"));
}

TEST_F(Programs, AlwaysStartsItsBodyAtOnceAndNeverEnds) {
  EXPECT_THAT(body("always a = x; b = y"),
              ElementsAre("1 (P())", "2 [1*] always: -> 2; -> 3", "3 [1*] a = x", "4 [1] b = y"));
}

TEST_F(Programs, Next) {
  EXPECT_THAT(body("next a = x; b = y"),
              ElementsAre("1 (P())", "2 [1*] next: -> 3", "3 [1] a = x: -> 4", "4 [1] b = y"));
}

TEST_F(Programs, WatchingAndMaintaining) {
  EXPECT_THAT(body("do a = x watching c = v; b = y"),
              ElementsAre("1 (P())", "2 [1*] (do … watching c = v) maintains not-entailed c = v: -> 4", "3 [2*] a = x",
                          "4 [1] b = y"));
  EXPECT_THAT(
      body("a = x maintaining c = v; b = y"),
      ElementsAre("1 (P())", "2 [1*] (do … maintaining c = v) maintains c = v: -> 4", "3 [2*] a = x", "4 [1] b = y"));
}

TEST_F(Programs, CallsAreComposite) {
  EXPECT_THAT(of("P() :: { A(); b = y }\nA() :: { a = x, c = z }"),
              ElementsAre("1 (P())", "2 [1*] (A()): -> 5", "3 [2*] a = x", "4 [2*] c = z", "5 [1] b = y"));
}

TEST_F(Programs, ParametersAreVariablesValuesAndConstraints) {
  EXPECT_THAT(of("P() :: { A(valve, open, t > 3 s & m = n), t = 0 }\nA(v, w, c) :: { when c donext v = w }"),
              ElementsAre("1 (P())", "2 [1*] (A(valve, open, t > 3 s & m = n))",
                          "3 [2*] when t > 3 s & m = n: not-entailed t > 3 s & m = n -> 3; t > 3 s & m = n -> 4",
                          "4 [2] valve = open", "5 [1*] t = 0"));
}

TEST_F(Programs, ParametersPassThroughCalls) {
  EXPECT_THAT(
      of("P() :: { A(valve, valve = open) }\nA(v, c) :: { B(c & v = shut, v) }\nB(d, w) :: { if d thennext w = "
         "open }"),
      ElementsAre("1 (P())", "2 [1*] (A(valve, valve = open))", "3 [2*] (B(valve = open & valve = shut, valve))",
                  "4 [3*] if valve = open & valve = shut: valve = open & valve = shut -> 5", "5 [3] valve = open"));
}

TEST_F(Programs, GoalsCanBeParameters) {
  EXPECT_THAT(of("P() :: { A(a = x & b = y) }\nA(g) :: { g }"),
              ElementsAre("1 (P())", "2 [1*] (A(a = x & b = y))", "3 [2*] a = x & b = y"));
}

TEST_F(Programs, TailCallGoesBack) {
  EXPECT_THAT(body("a = x; when c = v donext P()"),
              ElementsAre("1 (P())", "2 [1*] a = x: -> 3", "3 [1] when c = v: not-entailed c = v -> 3; c = v -> 2"));
}

TEST_F(Programs, MutualTailCallsGoBack) {
  EXPECT_THAT(of("P() :: { A() }\nA() :: { a = x; B() }\nB() :: { b = y; A() }"),
              ElementsAre("1 (P())", "2 [1*] (A())", "3 [2*] a = x: -> 4", "4 [2] (B())", "5 [4*] b = y: -> 3"));
}

TEST_F(Programs, ACallThatOnlyLeadsBackIsNoLocation) {
  EXPECT_THAT(of("P() :: { A() }\nA() :: { a = x; B() }\nB() :: { A() }"),
              ElementsAre("1 (P())", "2 [1*] (A())", "3 [2*] a = x: -> 3"));
}

TEST_F(Programs, TailCallsAreSpecialisedByTheirArguments) {
  EXPECT_THAT(
      of("P() :: { A(u, w) }\nA(v, next_one) :: { v = on; A(next_one, v) }"),
      ElementsAre("1 (P())", "2 [1*] (A(u, w))", "3 [2*] u = on: -> 4", "4 [2] (A(w, u))", "5 [4*] w = on: -> 3"));
}

TEST_F(Programs, WithoutAPlantNamesAreTakenAsTheyCome) {
  const Compilation result = compile_text("p.rmpl", "P() :: { if a = b thennext c = d; a = e }");
  ASSERT_TRUE(result.ok());
  const automata::Variables& variables = result.document().programs.at(0).variables;
  ASSERT_EQ(variables.size(), 2u);
  EXPECT_EQ(variables[automata::VariableId(0)], (automata::Variable{"a", {"b", "e"}}));
  EXPECT_EQ(variables[automata::VariableId(1)], (automata::Variable{"c", {"d"}}));
}

TEST_F(Programs, ListingsOfTheThesisCompile) {
  const std::string listings = rmpl::paths::source() + "/tests/unit/grammar/listings/";
  for (const char* one : {"fig_3_2", "fig_5_1", "fig_b_2", "fig_b_4"}) {
    EXPECT_THAT(findings(compile_files({listings + one + ".rmpl"})), IsEmpty()) << one;
  }
  const Compilation descent = compile_files(
      {listings + "fig_b_1.rmpl", listings + "fig_b_2.rmpl", listings + "fig_b_3.rmpl", listings + "fig_b_4.rmpl"});
  EXPECT_THAT(findings(descent), IsEmpty());
  EXPECT_EQ(descent.document().programs.at(0).name, "MarsEDL");
}

}  // namespace
}  // namespace rmpl::compiler
