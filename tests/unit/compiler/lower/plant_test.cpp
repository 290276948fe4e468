// Plant models as automata: order, names, transitions, times, weights.
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "grammar/source/render.hpp"
#include "tests/unit/compiler/workspace.hpp"

namespace rmpl::compiler {
namespace {

using automata::Formula;
using automata::ModeId;
using automata::Ticks;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* model = R"(
domain Level = { low, high };
component Valve {
  input cmd : { none, open };
  output flow : Level;
  initial closed;
  mode closed { flow = low };
  mode open { flow = high } reward -5;
  fault stuck reward -20;
  closed -> open when cmd = open in [1 s, 2 s] ~ normal(1.5 s, 0.2 s);
  any nominal -> stuck with rate 3.6 /h;
  open -> { closed with 1, stuck with 3 } when cmd != open after 1 min;
}
module Feed {
  input flow : Level;
  a : Valve;
  b : Valve { initial closed 0.5, open 0.5; };
  a.flow = flow;
}
plant Tanks {
  output level : Level;
  feed : Feed;
  spare : Valve;
  feed.flow = level;
  feed.b.flow = spare.flow -> spare = open;
  control feed.a.cmd, feed.b.cmd default none;
  observe spare.flow, level;
}
)";

class Plants : public Workspace {
 protected:
  void SetUp() override {
    const Compilation result = compile_text("p.tcca", model);
    ASSERT_THAT(grammar::render_text(result.findings(), false), IsEmpty());
    plant = result.document().plants.at(0);
  }
  [[nodiscard]] std::string text(const Formula& formula) const { return to_text(formula, plant.variables); }

  automata::Plant plant;
};

TEST_F(Plants, VariablesComeInOrderOfDeclarationDepthFirst) {
  Strings names;
  for (const auto& variable : plant.variables) names.push_back(variable.name);
  EXPECT_THAT(names, ElementsAre("level", "feed.flow", "feed.a", "feed.a.cmd", "feed.a.flow", "feed.b", "feed.b.cmd",
                                 "feed.b.flow", "spare", "spare.cmd", "spare.flow"));
}

TEST_F(Plants, ComponentsAreInstances) {
  ASSERT_EQ(plant.components.size(), 3u);
  const automata::Component& component = plant.components[1];
  EXPECT_EQ(component.name, "feed.b");
  EXPECT_EQ(component.type, "Valve");
  EXPECT_EQ(component.mode, *plant.variables.find("feed.b"));
  EXPECT_THAT(component.initial, ElementsAre(0.5, 0.5, 0));
  EXPECT_THAT(plant.components[2].initial, ElementsAre(1, 0, 0));
  EXPECT_THAT(plant.variables[component.mode].values, ElementsAre("closed", "open", "stuck"));
  EXPECT_EQ(text(component.modes[1].constraint), "feed.b.flow = high");
  EXPECT_EQ(component.modes[1].reward, -5);
  EXPECT_TRUE(component.modes[2].fault);
  EXPECT_TRUE(component.modes[2].constraint.is_true());
  EXPECT_EQ(component.modes[1].origin.line, 8u);
}

TEST_F(Plants, Transitions) {
  const auto& transitions = plant.components[2].transitions;
  ASSERT_EQ(transitions.size(), 5u);
  EXPECT_EQ(text(transitions[0].guard), "spare.cmd = open");
  ASSERT_TRUE(transitions[0].timing);
  EXPECT_EQ(transitions[0].timing->lower, Ticks::of_seconds(1));
  EXPECT_EQ(transitions[0].timing->upper, Ticks::of_seconds(2));
  EXPECT_EQ(transitions[0].timing->density.kind, automata::Density::Kind::normal);
  EXPECT_DOUBLE_EQ(transitions[0].timing->density.mean, 1.5);
  EXPECT_DOUBLE_EQ(transitions[0].timing->density.standard_deviation, 0.2);
  EXPECT_EQ(transitions[1].from, ModeId(0));
  EXPECT_EQ(transitions[2].from, ModeId(1));
  EXPECT_EQ(transitions[1].weight.kind, automata::Weight::Kind::rate);
  EXPECT_DOUBLE_EQ(transitions[1].weight.value, 0.001);
  EXPECT_EQ(transitions[1].branch, transitions[2].branch);
  EXPECT_NE(transitions[2].branch, transitions[3].branch);
  EXPECT_EQ(transitions[3].branch, transitions[4].branch);
  EXPECT_EQ(transitions[3].to, ModeId(0));
  EXPECT_DOUBLE_EQ(transitions[3].weight.value, 0.25);
  EXPECT_EQ(transitions[4].to, ModeId(2));
  EXPECT_EQ(text(transitions[4].guard), "spare.cmd = none");
  EXPECT_EQ(transitions[4].timing->lower, transitions[4].timing->upper);
  EXPECT_EQ(transitions[4].timing->upper, Ticks::of_seconds(60));
}

TEST_F(Plants, Interconnections) {
  ASSERT_EQ(plant.interconnections.size(), 3u);
  EXPECT_EQ(text(plant.interconnections[0].constraint), "feed.a.flow = feed.flow");
  EXPECT_EQ(text(plant.interconnections[1].constraint), "feed.flow = level");
  EXPECT_EQ(text(plant.interconnections[2].constraint), "feed.b.flow = spare.flow -> spare = open");
}

TEST_F(Plants, ControlsAndObservables) {
  ASSERT_EQ(plant.controls.size(), 2u);
  EXPECT_EQ(plant.variables.name(plant.controls[1].variable), "feed.b.cmd");
  EXPECT_EQ(plant.controls[1].idle, automata::ValueId(0));
  ASSERT_EQ(plant.observables.size(), 2u);
  EXPECT_EQ(plant.variables.name(plant.observables[0]), "spare.flow");
  EXPECT_EQ(plant.variables.name(plant.observables[1]), "level");
}

TEST_F(Plants, AnyIsEveryModeButTheTarget) {
  const Compilation result =
      compile_text("q.tcca",
                   "component C { mode a; mode b; fault f; fault g; initial a; any -> g with 0.1; any nominal -> a; }\n"
                   "plant P { c : C; }\n");
  ASSERT_TRUE(result.ok());
  Strings arcs;
  for (const auto& t : result.document().plants[0].components[0].transitions) {
    arcs.push_back(std::to_string(t.from.value) + ">" + std::to_string(t.to.value));
  }
  EXPECT_THAT(arcs, ElementsAre("0>3", "1>3", "2>3", "1>0"));
}

}  // namespace
}  // namespace rmpl::compiler
