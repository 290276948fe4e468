// What an executive does by default, rule by rule: what was asked, nothing else, and why (semantics 5).
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/reasoning/nominal/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/circle.hpp"
#include "tests/unit/runtime/reasoning/reconfigure/reconfigure_models.hpp"

namespace rmpl::runtime {
namespace {

using automata::conjunction;
using automata::constant;
using automata::Formula;
using automata::implication;
using crafts::Builder;
using crafts::Craft;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Outcome = Reconfiguration::Outcome;
using Obstacle = Reason::Obstacle;
using Purpose = Reason::Purpose;

/// Two modes, and a command each way.
void toggle(Builder& b, const std::string& name, const std::string& first, const std::string& second,
            double reward = 0) {
  b.control(name + ".cmd", {"none", name + ":" + first, name + ":" + second});
  b.component(name, {{first}, {second, constant(true), reward}});
  b.transition(first, second, b.is(name + ".cmd", name + ":" + second));
  b.transition(second, first, b.is(name + ".cmd", name + ":" + first));
}

TEST(GoalState, WhatWasAchievedStays) {
  Builder b;
  toggle(b, "acs", "idle", "active");
  toggle(b, "power", "external", "internal");
  Craft craft(std::move(b));
  EXPECT_THAT(craft.text(craft.plan({"idle", "external"}, craft.is("acs", "active")).commands),
              ElementsAre("acs:active"));
  EXPECT_THAT(craft.text(craft.plan({"active", "external"}, craft.is("power", "internal")).commands),
              ElementsAre("power:internal"));
  EXPECT_EQ(craft.next({"active", "internal"}, craft.is("power", "internal")).outcome, Outcome::nothing_to_do);
}

TEST(Circle, IsToldByWhatMovesFirstAndWhatTakesThatBack) {
  Builder b;
  toggle(b, "bus", "open", "closed");
  toggle(b, "lamp", "off", "on");
  const Craft craft(std::move(b));
  const auto open_off = craft.modes({"open", "off"}), open_on = craft.modes({"open", "on"});
  const auto closed_off = craft.modes({"closed", "off"}), closed_on = craft.modes({"closed", "on"});
  const auto told = [&](const std::vector<automata::Modes>& states) {
    return to_text(circle_in(craft.names.plant, states), craft.names.plant);
  };
  EXPECT_EQ(told({open_off, open_on, closed_on, closed_off, open_off}),
            "'lamp' from 'off' to 'on' is undone by 'on' to 'off'");
  EXPECT_EQ(told({open_on, closed_on, closed_off, open_off, open_on}),
            "'bus' from 'open' to 'closed' is undone by 'closed' to 'open'");
}

TEST(GoalState, RewardsAreComparedAsDecimals) {
  // In binary, 0.1 + 0.2 is more than 0.3.
  Builder b;
  toggle(b, "a", "off", "on", 0.1);
  toggle(b, "b", "off", "on", 0.2);
  toggle(b, "c", "off", "on", 0.3);
  for (const char* other : {"a", "b"}) b.connect(negation(conjunction({b.is(other, "on"), b.is("c", "on")})));
  Craft craft(std::move(b));
  const auto answer =
      craft.next({"off", "off", "on"}, automata::disjunction({craft.is("c", "on"), craft.is("c", "off")}));
  EXPECT_EQ(answer.outcome, Outcome::nothing_to_do);
}

TEST(Plan, WhatIsNeededGoesBeforeRewards) {
  Builder b;
  for (const char* heater : {"h1", "h2"}) toggle(b, heater, "off", "on", 1);
  b.control("fire", {"none", "fire"});
  b.component("pyro", {{"ready"}, {"fired"}});
  b.transition("ready", "fired", b.is("fire", "fire"));
  Craft craft(std::move(b));
  const Formula goal = craft.is("pyro", "fired");
  EXPECT_THAT(craft.text(craft.plan({"off", "off", "ready"}, goal).commands), ElementsAre("fire", "h1:on h2:on"));
  const auto first = craft.next({"off", "off", "ready"}, goal);
  EXPECT_EQ(first.why.purpose, Purpose::goal);
  EXPECT_EQ(first.why.conjunct, 0u);
  EXPECT_EQ(craft.next({"off", "off", "fired"}, goal).why.purpose, Purpose::reward);
}

TEST(Plan, HousekeepingKeepsTheGoal) {
  // The valve can be closed while the driver is on only, and the goal has the driver off.
  Builder b;
  b.control("cmd", {"none", "on", "off", "open", "close"});
  b.component("driver", {{"off"}, {"on"}});
  b.transition("off", "on", b.is("cmd", "on"));
  b.transition("on", "off", b.is("cmd", "off"));
  b.variable("out", {"no", "yes"});
  b.plant.components[0].modes[0].constraint = b.is("out", "no");
  b.plant.components[0].modes[1].constraint = b.is("out", "yes");
  b.component("valve", {{"closed"}, {"open", constant(true), -1}});
  b.transition("closed", "open", conjunction({b.is("cmd", "open"), b.is("out", "yes")}));
  b.transition("open", "closed", conjunction({b.is("cmd", "close"), b.is("out", "yes")}));
  Craft craft(std::move(b));
  const Plan plan = craft.plan({"on", "open"}, craft.is("driver", "off"));
  EXPECT_THAT(craft.text(plan.commands), ElementsAre("off"));
  EXPECT_THAT(craft.text(*plan.goal_state), ElementsAre("off", "open"));
}

TEST(Plan, RewardsWaitForNothingThatIsNotCommanded) {
  Builder b;
  b.variable("light", {"yes", "no"});
  b.component("sun", {{"light", b.is("light", "yes"), 5}, {"dark", b.is("light", "no")}});
  b.transition("light", "dark", constant(true), std::pair{1800, 1800});
  b.transition("dark", "light", constant(true), std::pair{1800, 1800});
  b.component("battery", {{"charging", constant(true), 1}, {"discharging"}});
  b.transition("charging", "discharging", b.is("light", "no"));
  b.transition("charging", "charging", b.is("light", "no"));
  b.transition("discharging", "charging", b.is("light", "yes"));
  Craft craft(std::move(b));
  const auto answer = craft.next({"dark", "charging"}, craft.is("battery", "discharging"));
  EXPECT_THAT(craft.text(*answer.goal_state), ElementsAre("dark", "discharging"));
  EXPECT_THAT(craft.text(*answer.expected), ElementsAre("dark", "discharging"));
  EXPECT_EQ(craft.next({"dark", "discharging"}, craft.is("battery", "discharging")).outcome, Outcome::nothing_to_do);
}

/// safe -> armed by command, armed -> fired by itself, and no way back from there.
Builder pyro() {
  Builder b;
  toggle(b, "lamp", "off", "on");
  b.control("cmd", {"none", "arm", "disarm"});
  b.component("pyro", {{"safe"}, {"armed"}, {"fired", constant(true), 1}});
  b.transition("safe", "armed", b.is("cmd", "arm"));
  b.transition("armed", "safe", b.is("cmd", "disarm"));
  b.transition("armed", "fired", constant(true), std::pair{3, 4});
  return b;
}

TEST(Irreversible, TimeIsNotUsedForRewards) {
  Craft craft(pyro());
  EXPECT_EQ(craft.next({"on", "safe"}, craft.is("lamp", "on")).outcome, Outcome::nothing_to_do);
  EXPECT_THAT(craft.text(craft.plan({"off", "safe"}, craft.is("pyro", "fired")).commands), ElementsAre("arm", "wait"));
}

TEST(Irreversible, WhereTimeCouldTakeAForbiddenStepNoCommandLeads) {
  Craft craft(pyro());
  const auto answer = craft.next({"off", "safe"}, craft.is("pyro", "armed"));
  EXPECT_EQ(answer.outcome, Outcome::no_plan);
  EXPECT_EQ(answer.why.obstacle, Obstacle::forbidden);
  ASSERT_TRUE(answer.why.step);
  EXPECT_EQ(answer.why.step->transition, automata::TransitionId(2));
  EXPECT_THAT(answer.reason, HasSubstr("the goal needs the irreversible step of 'pyro' from 'armed' to 'fired'"));
  EXPECT_THAT(remedy(answer.why, craft.names.plant), HasSubstr("pyro = fired"));
}

TEST(Irreversible, StepsLieOnTheWayToTheModeThatIsNamed) {
  Builder b;
  b.control("cmd", {"none", "deploy"});
  b.component("boom", {{"stowed"}, {"deploying"}, {"deployed"}});
  b.transition("stowed", "deploying", b.is("cmd", "deploy"));
  b.transition("deploying", "deployed", constant(true), std::pair{20, 60});
  Craft craft(std::move(b));
  EXPECT_THAT(craft.text(craft.plan({"stowed"}, craft.is("boom", "deployed")).commands), ElementsAre("deploy", "wait"));
  EXPECT_EQ(
      craft.next({"stowed"}, automata::disjunction({craft.is("boom", "stowed"), craft.is("boom", "deployed")})).outcome,
      Outcome::nothing_to_do);
}

TEST(Irreversible, AnAntecedentNamesNoMode) {
  Craft craft(pyro());
  const Formula goal = implication(craft.is("pyro", "fired"), craft.is("lamp", "on"));
  EXPECT_EQ(craft.next({"off", "safe"}, goal).outcome, Outcome::nothing_to_do);
  const auto named =
      named_modes(craft.names.plant, implication(negation(craft.is("pyro", "fired")), craft.is("lamp", "on")));
  EXPECT_TRUE(named[1][2] && named[0][1]);
  EXPECT_FALSE(named[1][0] || named[0][0]);
}

TEST(Irreversible, ANeededChangeThatEnablesAnothersIsNoPlan) {
  Builder b;
  b.control("cmd", {"none", "open", "close"});
  b.variable("flow", {"no", "yes"});
  b.component("valve", {{"closed", b.is("flow", "no")}, {"open", b.is("flow", "yes")}});
  b.transition("closed", "open", b.is("cmd", "open"));
  b.transition("open", "closed", b.is("cmd", "close"));
  b.component("disk", {{"intact"}, {"burst"}});
  b.transition("intact", "burst", b.is("flow", "yes"), std::pair{5, 6});
  Craft craft(std::move(b));
  const auto answer = craft.next({"closed", "intact"}, craft.is("valve", "open"));
  EXPECT_EQ(answer.outcome, Outcome::no_plan);
  EXPECT_THAT(answer.reason, HasSubstr("the goal needs the irreversible step of 'disk' from 'intact' to 'burst'"));
  const Formula both = conjunction({craft.is("valve", "open"), craft.is("disk", "burst")});
  EXPECT_THAT(craft.text(craft.plan({"closed", "intact"}, both).commands), ElementsAre("open", "wait"));
}

TEST(Irreversible, TheReasonSpeaksOfTheStepThatMustNotBeTaken) {
  Craft craft(crafts::lander());
  const auto answer = craft.next({"entry", "connected"}, craft.is("lander.contact", "broken"));
  EXPECT_EQ(answer.outcome, Outcome::no_plan);
  EXPECT_EQ(answer.why.obstacle, Obstacle::forbidden);
  EXPECT_THAT(answer.reason, HasSubstr("'lander' from 'connected' to 'separated'"));
}

TEST(Steps, ThatNeedNoCommandComeByThemselves) {
  Builder b;
  b.variable("src", {"p", "q"});
  b.component("s", {{"s", b.is("src", "p")}});
  b.component("m", {{"m0"}, {"m1"}});
  b.transition("m0", "m1", b.is("src", "p"));
  Craft craft(std::move(b));
  const auto answer = craft.next({"s", "m0"}, craft.is("m", "m1"));
  EXPECT_EQ(answer.outcome, Outcome::wait);
  EXPECT_EQ(answer.why.step, (TransitionOf{automata::ComponentId(1), automata::TransitionId(0)}));
  EXPECT_THAT(craft.text(*answer.expected), ElementsAre("s", "m1"));
}

TEST(Steps, WhereIdleControlsContradictTheModelAnotherActionIsSent) {
  Builder b;
  b.control("cmd", {"coast", "back", "hold", "go"});
  b.component("m", {{"a"}, {"b", negation(b.is("cmd", "coast"))}});
  b.transition("a", "b", b.is("cmd", "go"));
  b.transition("b", "a", b.is("cmd", "back"));
  Craft craft(std::move(b));
  EXPECT_EQ(craft.text(craft.next({"a"}, craft.is("m", "b")).action), "go");
  const auto answer = craft.next({"b"}, craft.is("m", "b"));
  EXPECT_EQ(answer.outcome, Outcome::command);
  EXPECT_EQ(craft.text(answer.action), "hold");
  EXPECT_EQ(answer.why.purpose, Purpose::model);
}

TEST(Reasons, TellTheWayAndTheTransition) {
  Craft craft(crafts::propulsion());
  const Formula goal = craft.is("engine", "firing");
  const auto first = craft.next({"off", "closed", "closed", "full", "full", "off"}, goal);
  EXPECT_EQ(to_text(first.why, craft.names.plant, goal),
            "for engine = firing, 'engine' to 'firing': 'pde' from 'off' to 'on'");
  const auto wait = craft.next({"on", "open", "open", "full", "full", "heating"}, goal);
  EXPECT_EQ(to_text(wait.why, craft.names.plant, goal),
            "for engine = firing, 'engine' to 'firing': 'engine' from 'heating' to 'standby'");
  const auto last = craft.next({"on", "open", "open", "full", "full", "firing"}, goal);
  EXPECT_EQ(to_text(last.why, craft.names.plant, goal), "for reward: 'pde' from 'on' to 'off'");
}

}  // namespace
}  // namespace rmpl::runtime
