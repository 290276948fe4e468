// Model programs in plants: threads as components, markings as modes.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "automata/assignment_text.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "tests/unit/compiler/workspace.hpp"

namespace rmpl::compiler {
namespace {

using automata::ValueId;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

class SoftwareInPlants : public Workspace {
 protected:
  Compilation compiled(const std::string& software, const std::string& plant) {
    write("software.rmpl", software);
    return compile_text("model.tcca", "import \"software.rmpl\";\n" + plant);
  }
  static std::vector<std::string> modes(const automata::Component& component, bool faults) {
    std::vector<std::string> result;
    for (const automata::Mode& mode : component.modes) {
      if (mode.fault == faults) result.push_back(mode.name);
    }
    return result;
  }
  /// `Idle -> Busy 0.9: t.ask = go`, with `!` before a consequence.
  static std::vector<std::string> transitions(const automata::Plant& plant, const automata::Component& component) {
    std::vector<std::string> result;
    for (const automata::Transition& t : component.transitions) {
      std::string text = t.consequence ? "!" : "";
      text += component.modes[t.from.index()].name + " -> " + component.modes[t.to.index()].name;
      if (t.weight.kind != automata::Weight::Kind::none) text += t.weight.value > 0.5 ? " likely" : " seldom";
      if (!t.guard.is_true()) text += ": " + to_text(t.guard, plant.variables);
      result.push_back(text);
    }
    return result;
  }
};

TEST_F(SoftwareInPlants, MarkingsAreModes) {
  const Compilation compilation = compiled(R"(
variable ask : { none, go };
variable x : { a, b, c };
model Task() :: { Idle() }
model Idle() :: { x = a, choose { if ask = go thennext Busy() elsenext Idle() with 0.9, next Odd() with 0.1 } }
model Busy() :: { x = b, next Idle() }
model Odd() :: { x = c, next Odder() }
model Odder() :: { x = c, choose { next Odd() with 0.9, next Idle() with 0.1 } }
)",
                                           "plant P { t : model Task; control t.ask default none; observe t.x; }");
  ASSERT_THAT(findings(compilation), IsEmpty());
  const automata::Plant& plant = compilation.document().plants.front();
  ASSERT_EQ(plant.components.size(), 1u);
  const automata::Component& task = plant.components.front();
  EXPECT_EQ(task.name, "t");
  EXPECT_EQ(task.type, "Task");
  EXPECT_TRUE(task.software);
  EXPECT_TRUE(task.progress);
  EXPECT_THAT(modes(task, false), UnorderedElementsAre("Idle", "Busy"));
  EXPECT_THAT(modes(task, true), UnorderedElementsAre("Odd", "Odder", "Idle_improbable"));
  EXPECT_EQ(to_text(task.modes.front().constraint, plant.variables), "t.x = a");
  EXPECT_THAT(
      transitions(plant, task),
      UnorderedElementsAre("Idle -> Odd seldom: t.ask = none", "Idle -> Busy likely: t.ask = go",
                           "Idle -> Odd seldom: t.ask = go", "Busy -> Idle", "!Odd -> Odder", "!Odder -> Odd likely",
                           "Odder -> Idle_improbable seldom", "Idle_improbable -> Idle likely: t.ask = none",
                           "Idle_improbable -> Odd seldom: t.ask = none", "Idle_improbable -> Busy likely: t.ask = go",
                           "Idle_improbable -> Odd seldom: t.ask = go"));
}

TEST_F(SoftwareInPlants, WhatIsDroppedIsAFault) {
  const Compilation compilation = compiled(R"(
variable ask : { none, go };
variable x : { a, b };
model Task() :: { Idle() }
model Idle() :: { x = a, choose { if ask = go thennext Busy() elsenext Idle() with 0.9, next Idle() with 0.1 } }
model Busy() :: { x = b, next Idle() }
)",
                                           "plant P { t : model Task; control t.ask default none; observe t.x; }");
  ASSERT_THAT(findings(compilation), IsEmpty());
  const automata::Plant& plant = compilation.document().plants.front();
  const automata::Component& task = plant.components.front();
  EXPECT_THAT(modes(task, false), ElementsAre("Idle", "Busy"));
  EXPECT_THAT(modes(task, true), ElementsAre("Idle_improbable", "Idle_improbable_2"));
  EXPECT_EQ(task.modes[2].usual, automata::ModeId(0));
  EXPECT_EQ(task.modes[3].usual, automata::ModeId(0));
  EXPECT_EQ(task.modes[3].constraint, task.modes[0].constraint);
  EXPECT_THAT(
      transitions(plant, task),
      UnorderedElementsAre(
          "Idle -> Busy likely: t.ask = go", "Idle -> Idle_improbable seldom: t.ask = go", "Busy -> Idle",
          "Idle_improbable -> Idle: t.ask = none", "Idle_improbable -> Busy likely: t.ask = go",
          "Idle_improbable -> Idle_improbable_2 seldom: t.ask = go", "Idle_improbable_2 -> Idle: t.ask = none",
          "Idle_improbable_2 -> Busy likely: t.ask = go", "Idle_improbable_2 -> Idle_improbable seldom: t.ask = go"));
  // The name of a marking stands for all of its modes.
  const auto named = [&](const std::string& text) { return compile_formula(text, plant, "--target").formula; };
  EXPECT_EQ(named("t = Idle"), automata::member(task.mode, {ValueId(0), ValueId(2), ValueId(3)}));
  EXPECT_EQ(named("t in { Idle }"), named("t = Idle"));
  EXPECT_EQ(named("t != Idle"), automata::is(task.mode, ValueId(1)));
  EXPECT_EQ(named("t = Idle_improbable"), automata::is(task.mode, ValueId(2)));
}

TEST_F(SoftwareInPlants, WhatNobodyTellsIsAskedOfModes) {
  const Compilation compilation = compiled(R"(
variable x : { a, b };
variable y : { a, b };
model Task() :: { Speaker(), Hearer() }
model Speaker() :: { x = a, next Silent() }
model Silent() :: { next Speaker() }
model Hearer() :: { y = a, unless x = a thennext Alarm(), if x = a thennext Hearer() }
model Alarm() :: { always y = b }
)",
                                           "plant P { t : model Task; observe t.y; }");
  ASSERT_THAT(findings(compilation), IsEmpty());
  const automata::Plant& plant = compilation.document().plants.front();
  ASSERT_EQ(plant.components.size(), 2u);
  EXPECT_EQ(plant.components[0].name, "t.Speaker");
  EXPECT_EQ(plant.components[1].name, "t.Hearer");
  EXPECT_THAT(transitions(plant, plant.components[1]), ElementsAre("Hearer -> Alarm: t.Speaker = Silent"));
}

TEST_F(SoftwareInPlants, LikeMarkingsAreOneMode) {
  const Compilation compilation = compiled(R"(
variable x : { a, b, c };
model Task() :: { A() }
model A() :: { x = a, choose { next B() with 0.9, next Burnt() with 0.06, next Torn() with 0.04 } }
model B() :: { x = b, choose { next A() with 0.9, next Burnt() with 0.1 } }
model Burnt() :: { always x = c }
model Torn() :: { always x = c }
)",
                                           "plant P { t : model Task; observe t.x; }");
  ASSERT_THAT(findings(compilation), IsEmpty());
  const automata::Component& task = compilation.document().plants.front().components.front();
  EXPECT_THAT(modes(task, false), UnorderedElementsAre("A", "B"));
  EXPECT_THAT(modes(task, true), UnorderedElementsAre("Burnt", "Torn")) << "two calls are one mode, two names are two";
}

TEST_F(SoftwareInPlants, AModelProgramIsAPlant) {
  const Compilation compilation = compile_text("software.rmpl", R"(
variable ask, now : { go, stop };
variable x, y : { a, b };
control ask;
control now default stop;
observe y;
model Both() :: { One(), Other() }
model One() :: { x = a, if ask = go thennext always x = b elsenext One() }
model Other() :: { always y = a }
)",
                                               {.model_is_plant = true});
  ASSERT_THAT(findings(compilation), IsEmpty());
  const automata::Plant& plant = compilation.document().plants.at(0);
  EXPECT_EQ(plant.name, "Both");
  ASSERT_EQ(plant.components.size(), 2u);
  EXPECT_EQ(plant.components[0].name, "One");
  EXPECT_EQ(plant.components[1].name, "Other");
  ASSERT_EQ(plant.controls.size(), 2u);
  EXPECT_EQ(to_text(plant.variables, automata::assignments_of(plant, automata::idle_action(plant))),
            "ask = unknown, now = stop");
  EXPECT_THAT(transitions(plant, plant.components[0]), ElementsAre("One_x_a -> One_x_b: ask.in_force = go"));
}

TEST_F(SoftwareInPlants, TimeRatesAndSoftwareStandSideBySide) {
  const Compilation compilation = compiled("variable p : { no, yes };\nmodel On() :: { always p = yes }", R"(
component Lamp { input p : { no, yes }; initial dark; mode dark; mode lit; fault dead;
  dark -> lit when p = yes in [2 s, 3 s]; lit -> dead with rate 1 /h; }
plant P { on : model On; lamp : Lamp; lamp.p = on.p; })");
  ASSERT_THAT(findings(compilation), IsEmpty());
  EXPECT_EQ(compilation.document().plants.front().components.size(), 2u);
  EXPECT_TRUE(compilation.document().models.empty());
}

TEST_F(SoftwareInPlants, TooManyMarkingsAreAnError) {
  std::string software = "variable a";
  std::string bits;
  for (char c = 'b'; c <= 'm'; ++c) software += std::string(", ") + c;
  for (char c = 'a'; c <= 'm'; ++c) bits += std::string(c == 'a' ? "" : ", ") + "Bit(" + c + ")";
  software += " : { no, yes };\nmodel All() :: { do { Most() } watching a = yes }\nmodel Most() :: { " + bits + " }\n" +
              "model Bit(x) :: { x = no, choose { next Bit(x) with 0.5, next always x = yes with 0.5 } }";
  EXPECT_THAT(findings(compiled(software, "plant P { all : model All; }")), ElementsAre("RMPL0318 model.tcca:2:11"));
}

}  // namespace
}  // namespace rmpl::compiler
