// Model programs: every construct, the automata of ijcai01 by hand, nested choices in two levels, recursion, the start.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "automata/json/document.hpp"
#include "grammar/source/render.hpp"
#include "tests/unit/compiler/workspace.hpp"

namespace rmpl::compiler {
namespace {

using automata::ModelProgram;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string text(const automata::Condition& condition, const ModelProgram& model) {
  if (condition.is_trivial()) return "";
  return (condition.entailed ? "" : "not-entailed ") + to_text(condition.constraint, model.variables);
}

std::string text(const std::vector<automata::GuardedArc>& arcs, const ModelProgram& model) {
  std::string result;
  for (const automata::GuardedArc& arc : arcs) {
    result += result.empty() ? " " : "; ";
    for (const automata::Condition& condition : arc.guard) result += text(condition, model) + " ";
    result += "-> " + std::to_string(arc.target.value + 1);
  }
  return result;
}

std::string numbers(const std::vector<automata::LocationId>& locations) {
  std::string result;
  for (const automata::LocationId location : locations) {
    result += (result.empty() ? "" : " ") + std::to_string(location.value + 1);
  }
  return "{" + result + "}";
}

std::string shortest(double probability) { return automata::Json(probability).dump(); }

/// `4 [1*] when x = a: not-entailed x = a -> 4; x = a -> 5`: number, parent (with a star for a start location), label,
/// maintenance, arcs. A choice has its functions, `0.5 {7 8}`; before time 0 `first 0.5 {7 8}`.
std::vector<std::string> lines(const ModelProgram& model) {
  std::vector<std::string> result;
  for (std::size_t l = 0; l < model.locations.size(); ++l) {
    const automata::ModelLocation& location = model.locations[l];
    std::string line = std::to_string(l + 1);
    if (location.parent) line += " [" + std::to_string(location.parent->value + 1) + (location.start ? "*]" : "]");
    line += location.composite ? " (" + location.label + ")" : " " + location.label;
    if (!location.maintenance.is_trivial()) line += " maintains " + text(location.maintenance, model);
    std::string more = text(location.arcs, model);
    for (const automata::TransitionFunction& function : location.functions) {
      if (!function.started.empty()) more += " " + shortest(function.probability) + " " + numbers(function.started);
      more += text(function.arcs, model);
    }
    result.push_back(line + (more.empty() ? "" : ":" + more));
  }
  for (const automata::InitialDraw& draw : model.initial) {
    std::string& line = result[draw.choice.index()];
    line += ": first";
    for (const auto& branch : draw.branches) line += " " + shortest(branch.probability) + " " + numbers(branch.started);
  }
  return result;
}

class Models : public Workspace {
 protected:
  /// Two variables, x and y, of values a and b.
  std::vector<std::string> of(const std::string& definitions) {
    const Compilation result = compile_text("m.rmpl", "variable x, y : { a, b };\n" + definitions);
    EXPECT_THAT(grammar::render_text(result.findings(), false), IsEmpty());
    if (!result.ok()) return {};
    const std::string json = automata::to_text(result.document());
    EXPECT_EQ(automata::read_document(json, "m.json"), result.document());
    return lines(result.document().models.at(0));
  }
  std::vector<std::string> body(const std::string& source) { return of("model P() :: { " + source + " }"); }
};

TEST_F(Models, Constructs) {
  EXPECT_THAT(body("x = a | y = a; x = y"), ElementsAre("1 (P())", "2 [1*] x = a | y = a: -> 3", "3 [1] x = y"));
  EXPECT_THAT(body("x = a, y = b"), ElementsAre("1 (P())", "2 [1*] x = a", "3 [1*] y = b"));
  EXPECT_THAT(
      body("if x = a thennext y = a elsenext y = b"),
      ElementsAre("1 (P())", "2 [1*] if x = a: x = a -> 3; not-entailed x = a -> 4", "3 [1] y = a", "4 [1] y = b"));
  EXPECT_THAT(body("when x = a donext y = a"),
              ElementsAre("1 (P())", "2 [1*] when x = a: not-entailed x = a -> 2; x = a -> 3", "3 [1] y = a"));
  EXPECT_THAT(body("whenever x = a donext y = a"),
              ElementsAre("1 (P())", "2 [1*] whenever x = a: -> 2; x = a -> 3", "3 [1] y = a"));
  EXPECT_THAT(
      body("next x = a maintaining y = b"),
      ElementsAre("1 (P())", "2 [1*] next: -> 3", "3 [1] (do … maintaining y = b) maintains y = b", "4 [3*] x = a"));
}

/// The automaton of the paper's section "Hierarchical constraint automata": c is told until d.
TEST_F(Models, DoAlwaysWatching) {
  EXPECT_THAT(body("do always x = a watching y = b"),
              ElementsAre("1 (P())", "2 [1*] (do … watching y = b) maintains not-entailed y = b",
                          "3 [2*] always: -> 3; -> 4", "4 [2*] x = a"));
}

TEST_F(Models, Unless) {
  EXPECT_THAT(body("unless y = b thennext x = a"),
              ElementsAre("1 (P())", "2 [1*] unless y = b: not-entailed y = b -> 3", "3 [1] x = a"));
}

TEST_F(Models, CallsWithParameters) {
  EXPECT_THAT(of("model P() :: { Set(x, b), When(x = b, y) } model Set(v, w) :: { v = w }"
                 "model When(c, v) :: { if c thennext Set(v, a) }"),
              ElementsAre("1 (P())", "2 [1*] (Set(x, b))", "3 [2*] x = b", "4 [1*] (When(x = b, y))",
                          "5 [4*] if x = b: x = b -> 6", "6 [4] (Set(y, a))", "7 [6*] y = a"));
}

/// The tree by hand: 0.4 of (0.5 of next x = a, 0.5 of if y = b thennext x = b), 0.6 of both of two arcs; distributed
/// and merged: 0.2 to 6; 0.2 to 8 under y = b; 0.6 to 11, and to 13 under x = a.
TEST_F(Models, NestedChoicesInTwoLevels) {
  EXPECT_THAT(body("always choose {"
                   "  choose { next x = a with 0.5, if y = b thennext x = b with 0.5 } with 0.4,"
                   "  { next y = a, if x = a thennext y = b } with 0.6"
                   "}"),
              ElementsAre("1 (P())", "2 [1*] always: -> 2; -> 3", "3 [1*] choose: 0.2 {5} 0.2 {7} 0.6 {10 12}",
                          "4 [1] choose: 0.5 {5} 0.5 {7}", "5 [1] next: -> 6", "6 [1] x = a",
                          "7 [1] if y = b: y = b -> 8", "8 [1] x = b", "9 [1] ({ … , … })", "10 [9*] next: -> 11",
                          "11 [9] y = a", "12 [9*] if x = a: x = a -> 13", "13 [9] y = b"));
}

TEST_F(Models, ChoicesSideBySideInABranchAreMultiplied) {
  EXPECT_THAT(body("always choose {"
                   "  { choose { next x = a with 0.5, next x = b with 0.5 }, choose { next y = a with 0.25, next y = b "
                   "with 0.75 } }"
                   "    with 0.5,"
                   "  true with 0.5 }")[2],
              "3 [1*] choose: 0.0625 {6 11} 0.1875 {6 13} 0.0625 {8 11} 0.1875 {8 13} 0.5 {15}");
}

TEST_F(Models, WhatFollowsAChoiceFollowsEachBranch) {
  EXPECT_THAT(body("next choose { next x = a with 2, if y = a thennext x = b with 2 }; y = b"),
              ElementsAre("1 (P())", "2 [1*] next: -> 3", "3 [1] choose: 0.5 {4} 0.5 {6}", "4 [1] next: -> 5",
                          "5 [1] x = a: -> 8", "6 [1] if y = a: y = a -> 7; not-entailed y = a -> 8",
                          "7 [1] x = b: -> 8", "8 [1] y = b"));
}

TEST_F(Models, AChoiceThatStartsOnlyWithTheProgramIsDrawnFirst) {
  EXPECT_THAT(body("choose { x = a with 3, x = b with 1 }; y = a"),
              ElementsAre("1 (P())", "2 [1] choose: first 0.75 {3} 0.25 {4}", "3 [1] x = a: -> 5", "4 [1] x = b: -> 5",
                          "5 [1] y = a"));
}

TEST_F(Models, TheStartOfCompositesInABranchThatIsDrawnFirst) {
  EXPECT_THAT(
      body("choose { do { y = a, choose { x = a with 0.5, x = b with 0.5 } } watching y = b with 0.5, true with 0.5 }"),
      ElementsAre("1 (P())", "2 [1] choose: first 0.25 {3 6} 0.25 {3 7} 0.5 {8}",
                  "3 [1] (do … watching y = b) maintains not-entailed y = b", "4 [3*] y = a", "5 [3] choose",
                  "6 [3] x = a", "7 [3] x = b", "8 [1] true"));
}

TEST_F(Models, AChoiceThatIsStartedAgainIsMarkedUndrawn) {
  EXPECT_THAT(of("model P() :: { choose { next x = a with 0.5, next x = b with 0.5 }; next P() }"),
              ElementsAre("1 (P())", "2 [1*] choose: 0.5 {3} 0.5 {5}", "3 [1] next: -> 4", "4 [1] x = a: -> 7",
                          "5 [1] next: -> 6", "6 [1] x = b: -> 7", "7 [1] next: -> 1"));
  // In a branch that is drawn first it is among what starts.
  EXPECT_THAT(body("choose { always choose { next x = a with 1 } with 0.5, y = b with 0.5 }"),
              ElementsAre("1 (P())", "2 [1] choose: first 0.5 {3 4} 0.5 {7}", "3 [1] always: -> 3; -> 4",
                          "4 [1] choose: 1.0 {5}", "5 [1] next: -> 6", "6 [1] x = a", "7 [1] y = b"));
}

TEST_F(Models, RecursionIsAnArcBack) {
  EXPECT_THAT(of("model P() :: { x = a, next P() }"), ElementsAre("1 (P())", "2 [1*] x = a", "3 [1*] next: -> 1"));
  EXPECT_THAT(
      of("model P() :: { Q(x); y = b } model Q(v) :: { v = a; if y = a thennext Q(v) }"),
      ElementsAre("1 (P())", "2 [1*] (Q(x)): -> 5", "3 [2*] x = a: -> 4", "4 [2] if y = a: y = a -> 2", "5 [1] y = b"));
}

TEST_F(Models, MutualRecursionIsCompiledOnce) {
  EXPECT_THAT(of("model P() :: { Up() }"
                 "model Up() :: { x = a; choose { next Down() with 0.5, next next Down() with 0.5 } }"
                 "model Down() :: { x = b; next Up() }"),
              ElementsAre("1 (P())", "2 [1*] (Up())", "3 [2*] x = a: -> 4", "4 [2] choose: 0.5 {5} 0.5 {9}",
                          "5 [2] next: -> 6", "6 [2] (Down())", "7 [6*] x = b: -> 8", "8 [6] next: -> 2",
                          "9 [2] next: -> 10", "10 [2] next: -> 6"));
}

TEST_F(Models, ACallThatLeadsBackBesideAnotherThread) {
  EXPECT_THAT(of("model P() :: { Up() } model Up() :: { x = a; next Both() } model Both() :: { Up(), y = b }"),
              ElementsAre("1 (P())", "2 [1*] (Up())", "3 [2*] x = a: -> 4", "4 [2] next: -> 5; -> 2", "5 [2] (Both())",
                          "6 [5*] y = b"));
}

TEST_F(Models, Declarations) {
  const Compilation result = compile_text("m.rmpl",
                                          "domain Level = { low, high }; variable power, spare : Level;"
                                          "variable cmd : { none, on }; observe power; control cmd default none;"
                                          "control spare; constraint cmd = on -> power = high;"
                                          "model Main() :: { always spare = low }");
  ASSERT_TRUE(result.ok());
  const ModelProgram& model = result.document().models.at(0);
  EXPECT_THAT(model.observables, ElementsAre(automata::VariableId(std::size_t{0})));
  ASSERT_EQ(model.controls.size(), 2u);
  EXPECT_EQ(model.controls[0].idle, automata::ValueId(std::size_t{0}));
  EXPECT_EQ(model.controls[1].idle, std::nullopt);
  ASSERT_EQ(model.constraints.size(), 1u);
  EXPECT_EQ(to_text(model.constraints[0].constraint, model.variables), "cmd = on -> power = high");
  EXPECT_EQ(model.name, "Main");
  EXPECT_EQ(automata::read_document(automata::to_text(result.document()), "m.json"), result.document());
}

}  // namespace
}  // namespace rmpl::compiler
