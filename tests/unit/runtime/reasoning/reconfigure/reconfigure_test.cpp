// Reconfiguration as a whole: the examples of thesis 6.3 and their neighbours, command by command.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/runtime/reasoning/reconfigure/reconfigure_models.hpp"

namespace rmpl::runtime {
namespace {

using automata::conjunction;
using automata::Formula;
using crafts::Builder;
using crafts::Craft;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Outcome = Reconfiguration::Outcome;

const std::vector<std::string> all_off{"off", "closed", "closed", "full", "full", "off"};

TEST(Propulsion, FiresAsInSection633) {
  Craft craft(crafts::propulsion());
  const Plan plan = craft.plan(all_off, craft.is("engine", "firing"));
  ASSERT_EQ(plan.outcome, Plan::Outcome::plan) << plan.reason;
  EXPECT_THAT(craft.text(*plan.goal_state), ElementsAre("off", "open", "open", "full", "full", "firing"));
  EXPECT_THAT(craft.text(plan.commands),
              ElementsAre("on", "standbyEngine", "open1", "open2", "wait", "fireEngine", "off"));
}

TEST(Propulsion, GoesToStandbyAndTurnsTheDriverOff) {
  Craft craft(crafts::propulsion());
  const Plan plan = craft.plan(all_off, craft.is("engine", "standby"));
  EXPECT_THAT(craft.text(plan.commands), ElementsAre("on", "standbyEngine", "off", "wait"));
}

TEST(Propulsion, ShutsDownFromFiringEngineFirst) {
  Craft craft(crafts::propulsion());
  const Plan plan = craft.plan({"off", "open", "open", "full", "full", "firing"}, craft.is("engine", "off"));
  EXPECT_THAT(craft.text(plan.commands), ElementsAre("on", "standbyEngine", "offEngine", "close1", "close2", "off"));
}

TEST(Propulsion, WaitsWhileTheEngineHeats) {
  Craft craft(crafts::propulsion());
  const auto answer = craft.next({"on", "open", "open", "full", "full", "heating"}, craft.is("engine", "firing"));
  EXPECT_EQ(answer.outcome, Outcome::wait);
  EXPECT_EQ(craft.text(answer.action), "wait");
  EXPECT_THAT(craft.text(*answer.expected), ElementsAre("on", "open", "open", "full", "full", "standby"));
  EXPECT_FALSE(answer.irreversible);
}

TEST(Propulsion, GoalsOverAttributesAreEntailed) {
  Craft craft(crafts::propulsion());
  const auto answer = craft.next(all_off, craft.is("engine.thrust", "full"));
  ASSERT_TRUE(answer.goal_state);
  EXPECT_THAT(craft.text(*answer.goal_state), ElementsAre("on", "open", "open", "full", "full", "firing"));
  const auto either =
      craft.next(all_off, automata::disjunction({craft.is("engine.thrust", "full"), craft.is("engine", "off")}));
  EXPECT_EQ(either.outcome, Outcome::nothing_to_do);
}

TEST(Propulsion, ResetsTheDriverWhereItIsNeeded) {
  Craft craft(crafts::propulsion());
  const std::vector<std::string> tripped{"resettable", "closed", "closed", "full", "full", "standby"};
  EXPECT_THAT(craft.text(craft.plan(tripped, craft.is("engine", "firing")).commands),
              ElementsAre("reset", "open1", "open2", "fireEngine", "off"));
}

TEST(Propulsion, TurnsATrippedDriverOffWhereItIsNot) {
  Craft craft(crafts::propulsion());
  const auto tripped =
      craft.next({"resettable", "closed", "closed", "full", "full", "standby"}, craft.is("engine", "standby"));
  EXPECT_EQ(craft.text(tripped.action), "off");
  const auto heating =
      craft.next({"resettable", "closed", "closed", "full", "full", "heating"}, craft.is("engine", "standby"));
  EXPECT_EQ(craft.text(heating.action), "off") << "a repair goes before a wait";
}

TEST(Propulsion, UsesAStuckOpenValve) {
  Craft craft(crafts::propulsion());
  const Plan plan =
      craft.plan({"off", "stuck-open", "closed", "full", "full", "standby"}, craft.is("engine", "firing"));
  EXPECT_THAT(craft.text(plan.commands), ElementsAre("on", "open2", "fireEngine", "off"));
}

TEST(Propulsion, NamesTheValveThatForbidsFiring) {
  Craft craft(crafts::propulsion());
  const auto answer =
      craft.next({"off", "stuck-closed", "closed", "full", "full", "standby"}, craft.is("engine", "firing"));
  EXPECT_EQ(answer.outcome, Outcome::no_plan);
  ASSERT_TRUE(answer.component);
  EXPECT_EQ(craft.names.plant[*answer.component].name, "valve1");
  EXPECT_EQ(answer.reason,
            "no permitted nominal transitions lead 'valve1' from 'stuck-closed' to 'open' or 'stuck-open', as "
            "'engine' needs to go from 'standby' to 'firing'");
  EXPECT_EQ(craft.text(answer.action), "wait");
}

TEST(Propulsion, NamesTheDriverThatCutsTheEngineOff) {
  Craft craft(crafts::propulsion());
  const auto answer = craft.next({"failed", "closed", "closed", "full", "full", "off"}, craft.is("engine", "standby"));
  EXPECT_EQ(answer.outcome, Outcome::no_plan);
  ASSERT_TRUE(answer.component);
  EXPECT_EQ(craft.names.plant[*answer.component].name, "pde");
  EXPECT_EQ(answer.reason,
            "no permitted nominal transitions lead 'pde' from 'failed' to 'on', as 'engine' needs to go from "
            "'off' to 'heating'");
}

TEST(Propulsion, AFailedEngineCannotBeBroughtBack) {
  Craft craft(crafts::propulsion());
  const auto answer = craft.next({"off", "closed", "closed", "full", "full", "failed"}, craft.is("engine", "standby"));
  EXPECT_EQ(answer.outcome, Outcome::no_plan);
  EXPECT_EQ(answer.reason, "no permitted nominal transitions lead 'engine' from 'failed' to 'standby'");
}

TEST(Propulsion, AsksForNothingWhereTheGoalIsTrue) {
  Craft craft(crafts::propulsion());
  const std::vector<std::string> awkward{"on", "open", "closed", "full", "full", "heating"};
  const auto answer = craft.next(awkward, automata::constant(true));
  EXPECT_EQ(answer.outcome, Outcome::nothing_to_do);
  EXPECT_EQ(craft.plan(awkward, automata::constant(true)).outcome, Plan::Outcome::nothing_to_do);
  EXPECT_EQ(craft.next(all_off, automata::constant(false)).outcome, Outcome::no_plan);
}

TEST(Propulsion, AnswersDoNotDependOnWhatWasAskedBefore) {
  Craft fresh(crafts::propulsion());
  Craft used(crafts::propulsion());
  const Formula goal = fresh.is("engine", "firing");
  for (const char* engine : {"standby", "heating", "off"}) {
    used.plan({"on", "open", "closed", "full", "full", engine}, used.is("engine.thrust", "zero"));
  }
  const Plan a = fresh.plan(all_off, goal);
  const Plan b = used.plan(all_off, goal);
  EXPECT_EQ(a.commands, b.commands);
}

TEST(Lander, SeparatesWhenTheGoalNamesIt) {
  Craft craft(crafts::lander());
  const auto answer = craft.next({"cruise", "connected"}, craft.is("lander", "separated"));
  EXPECT_EQ(craft.text(answer.action), "fire-primary");
  EXPECT_TRUE(answer.irreversible);
}

TEST(Lander, TriesTheBackupAfterAnUnsuccessfulAttempt) {
  Craft craft(crafts::lander());
  const auto answer = craft.next({"cruise", "unsuccessful-attempt"}, craft.is("lander", "separated"));
  EXPECT_EQ(craft.text(answer.action), "fire-backup");
}

TEST(Lander, DoesNotSeparateForTheRewardAlone) {
  Craft craft(crafts::lander());
  const Plan plan = craft.plan({"cruise", "connected"}, craft.is("att", "entry"));
  EXPECT_THAT(craft.text(*plan.goal_state), ElementsAre("entry", "connected"));
  EXPECT_THAT(craft.text(plan.commands), ElementsAre("to-entry", "wait"));
}

TEST(Lander, DoesNotReachAnAttributeByAnIrreversibleStep) {
  Craft craft(crafts::lander());
  const auto answer = craft.next({"entry", "connected"}, craft.is("lander.contact", "broken"));
  EXPECT_EQ(answer.outcome, Outcome::no_plan);
}

TEST(Lander, DoesNotLetOneIslandWaitForAnother) {
  Craft craft(crafts::lander());
  const Formula both = conjunction({craft.is("att", "entry"), craft.is("lander", "separated")});
  EXPECT_THAT(craft.text(craft.plan({"slewing", "connected"}, both).commands), ElementsAre("fire-primary", "wait"));
}

TEST(Rules, TiesGoToWhatIsDeclaredFirst) {
  Builder b;
  b.control("cmd", {"none", "a", "b", "c"});
  b.component("x", {{"one"}, {"two"}, {"three"}});
  b.transition("one", "two", b.is("cmd", "b"));
  b.transition("one", "three", b.is("cmd", "c"));
  b.transition("two", "one", b.is("cmd", "a"));
  b.transition("three", "one", b.is("cmd", "a"));
  Craft craft(std::move(b));
  const auto answer = craft.next({"one"}, negation(craft.is("x", "one")));
  EXPECT_THAT(craft.text(*answer.goal_state), ElementsAre("two"));
  EXPECT_EQ(craft.text(answer.action), "b");
}

/// One command opens both doors; the second is a pyro door that never closes again.
Builder doors(bool second_closes) {
  Builder b;
  b.control("cmd", {"none", "both", "close2"});
  b.control("slow", {"none", "first"});
  b.component("door1", {{"closed"}, {"open", automata::constant(true), -1}});
  b.transition("closed", "open", b.is("cmd", "both"));
  b.transition("open", "closed", b.is("slow", "first"));
  b.component("door2", {{"closed"}, {"open", automata::constant(true), -1}});
  b.transition("closed", "open", b.is("cmd", "both"));
  if (second_closes) b.transition("open", "closed", b.is("cmd", "close2"));
  return b;
}

TEST(Rules, NoIrreversibleStepAsASideEffect) {
  Craft craft(doors(false));
  const auto answer = craft.next({"closed", "closed"}, craft.is("door1", "open"));
  EXPECT_EQ(answer.outcome, Outcome::no_plan);
  ASSERT_TRUE(answer.component);
  EXPECT_EQ(craft.names.plant[*answer.component].name, "door2");
  EXPECT_THAT(answer.reason, HasSubstr("the irreversible step of"));
}

TEST(Rules, AReversibleSideEffectIsUndoneAfterwards) {
  Craft craft(doors(true));
  const Plan plan = craft.plan({"closed", "closed"}, craft.is("door1", "open"));
  EXPECT_THAT(craft.text(*plan.goal_state), ElementsAre("open", "closed"));
  EXPECT_THAT(craft.text(plan.commands), ElementsAre("both", "close2"));
}

TEST(Rules, AnInequalityNamesNoMode) {
  Builder b;
  b.control("cmd", {"none", "open", "close", "blow"});
  b.component("valve", {{"closed"}, {"open"}, {"blown", automata::constant(true), 10}});
  b.transition("closed", "open", b.is("cmd", "open"));
  b.transition("open", "closed", b.is("cmd", "close"));
  b.transition("closed", "blown", b.is("cmd", "blow"));
  Craft craft(std::move(b));
  const auto valve = craft.names.plant.components.front().mode;
  const Formula unequal = automata::member(valve, {automata::ValueId(1), automata::ValueId(2)});
  for (const Formula& goal : {unequal, negation(craft.is("valve", "closed"))}) {
    EXPECT_THAT(craft.text(craft.plan({"closed"}, goal).commands), ElementsAre("open"));
  }
  EXPECT_THAT(craft.text(craft.plan({"closed"}, craft.is("valve", "blown")).commands), ElementsAre("blow"));
}

/// Two heaters that burn for a moment only; bound, they must not heat at once, else neither knows of the other.
Builder heaters(bool bound) {
  Builder b;
  for (const std::string name : {"h", "g"}) {
    b.control(name + ".cmd", {"none", name + ":on", name + ":fire"});
    b.component(name, {{"off"}, {"heat"}, {"rdy"}, {"burn"}});
    b.transition("off", "heat", b.is(name + ".cmd", name + ":on"));
    b.transition("heat", "rdy", automata::constant(true), std::pair{30, 60});
    b.transition("rdy", "off", b.is(name + ".cmd", name + ":on"));
    b.transition("rdy", "burn", b.is(name + ".cmd", name + ":fire"));
    b.transition("burn", "rdy", automata::constant(true), std::pair{1, 2});
  }
  if (bound) b.connect(negation(conjunction({b.is("h", "heat"), b.is("g", "heat")})));
  return b;
}

TEST(Waits, WhatDoesNotLastIsAchievedLast) {
  Craft craft(heaters(true));
  const Plan both = craft.plan({"off", "off"}, conjunction({craft.is("h", "burn"), craft.is("g", "burn")}));
  EXPECT_THAT(craft.text(both.commands), ElementsAre("h:on", "wait", "g:on", "wait", "h:fire g:fire"));
  const Plan one = craft.plan({"off", "off"}, conjunction({craft.is("h", "burn"), craft.is("g", "rdy")}));
  EXPECT_THAT(craft.text(one.commands), ElementsAre("h:on", "wait", "g:on", "wait", "h:fire"));
}

TEST(Waits, WhatDoesNotLastIsLeftAndAchievedAgain) {
  Craft craft(heaters(true));
  const Plan plan = craft.plan({"burn", "off"}, conjunction({craft.is("h", "burn"), craft.is("g", "burn")}));
  ASSERT_EQ(plan.outcome, Plan::Outcome::plan) << plan.reason;
  EXPECT_THAT(craft.text(plan.commands), ElementsAre("g:on", "wait", "wait", "h:fire g:fire"));
}

/// A heater that cools once the bus is dead or it is told to, and a motor on the same bus.
Builder rig() {
  Builder b;
  b.control("s.cmd", {"none", "close", "open"});
  b.variable("bus", {"off", "on"});
  b.component("s", {{"opened", b.is("bus", "off")}, {"closed", b.is("bus", "on")}});
  b.transition("opened", "closed", b.is("s.cmd", "close"));
  b.transition("closed", "opened", b.is("s.cmd", "open"));
  b.control("h.cmd", {"none", "heat", "rest"});
  b.component("h", {{"cold"}, {"warm"}, {"cooling"}});
  b.transition("cold", "warm", conjunction({b.is("h.cmd", "heat"), b.is("bus", "on")}));
  b.transition("warm", "cooling", b.is("bus", "off"));
  b.transition("warm", "cooling", b.is("h.cmd", "rest"));
  b.transition("cooling", "cold", automata::constant(true), std::pair{60, 60});
  b.control("m.cmd", {"none", "start", "stop"});
  b.component("m", {{"idle"}, {"running"}});
  b.transition("idle", "running", b.is("m.cmd", "start"));
  b.transition("running", "idle", b.is("m.cmd", "stop"));
  b.transition("running", "idle", b.is("bus", "off"));
  return b;
}

TEST(Waits, GoalsThatHaveNothingToDoWithEachOtherDoNotWaitForEachOther) {
  Craft craft(rig());
  const Plan stop =
      craft.plan({"closed", "cooling", "running"}, conjunction({craft.is("h", "cold"), craft.is("m", "idle")}));
  EXPECT_THAT(craft.text(stop.commands), ElementsAre("stop", "wait"));
  const Plan start =
      craft.plan({"closed", "cooling", "idle"}, conjunction({craft.is("h", "cold"), craft.is("m", "running")}));
  EXPECT_THAT(craft.text(start.commands), ElementsAre("start", "wait"));
}

TEST(Rules, OfTransitionsBetweenTheSameModesTheNearestIsTaken) {
  Craft craft(rig());
  const Plan plan = craft.plan({"closed", "warm", "running"}, craft.is("h", "cold"));
  EXPECT_THAT(craft.text(plan.commands), ElementsAre("rest", "wait"));
  EXPECT_THAT(craft.text(*plan.goal_state), ElementsAre("closed", "cold", "running"));
}

TEST(Waits, OtherPartsOfThePlantAreWaitedForToo) {
  Craft craft(heaters(false));
  const Plan plan = craft.plan({"off", "off"}, conjunction({craft.is("h", "burn"), craft.is("g", "burn")}));
  EXPECT_THAT(craft.text(plan.commands), ElementsAre("h:on g:on", "wait", "wait", "h:fire g:fire"));
}

TEST(Waits, AreNoneThatLetAForbiddenStepCome) {
  // The flare burns out while the lamp warms up, and there is no second one; while the lamp is off the model stops it.
  Builder b;
  b.control("cmd", {"none", "go", "stop"});
  b.component("flare", {{"burning"}, {"out"}});
  b.transition("burning", "out", automata::constant(true), std::pair{1, 2});
  b.component("lamp", {{"off"}, {"warming"}, {"on"}});
  b.transition("off", "warming", b.is("cmd", "go"));
  b.transition("warming", "on", automata::constant(true), std::pair{30, 60});
  b.transition("on", "off", b.is("cmd", "stop"));
  b.connect(automata::disjunction({negation(b.is("flare", "out")), negation(b.is("lamp", "off"))}));
  Craft craft(std::move(b));
  const Plan plan = craft.plan({"burning", "off"}, conjunction({craft.is("flare", "burning"), craft.is("lamp", "on")}));
  EXPECT_EQ(plan.outcome, Plan::Outcome::no_plan);
  EXPECT_THAT(plan.reason, HasSubstr("the goal needs the irreversible step of 'flare' from 'burning' to 'out'"));
}

TEST(Rules, ComponentsThatControlEachOtherArePlannedAsOne) {
  // Each of two locks moves only while the other is open; both start open, and one command closes or opens each.
  Builder b;
  b.control("cmd", {"none", "open1", "close1", "open2", "close2"});
  b.variable("way1", {"no", "yes"});
  b.variable("way2", {"no", "yes"});
  b.component("lock1", {{"open", b.is("way1", "yes")}, {"closed", b.is("way1", "no")}});
  b.transition("open", "closed", conjunction({b.is("cmd", "close1"), b.is("way2", "yes")}));
  b.transition("closed", "open", conjunction({b.is("cmd", "open1"), b.is("way2", "yes")}));
  b.component("lock2", {{"open", b.is("way2", "yes")}, {"closed", b.is("way2", "no")}});
  b.transition("open", "closed", conjunction({b.is("cmd", "close2"), b.is("way1", "yes")}));
  b.transition("closed", "open", conjunction({b.is("cmd", "open2"), b.is("way1", "yes")}));
  Craft craft(std::move(b));
  const Formula swapped = conjunction({craft.is("lock1", "closed"), craft.is("lock2", "open")});
  EXPECT_THAT(craft.text(craft.plan({"open", "closed"}, swapped).commands), ElementsAre("open2", "close1"));
  const Formula both = conjunction({craft.is("lock1", "closed"), craft.is("lock2", "closed")});
  EXPECT_EQ(craft.next({"open", "open"}, both).outcome, Outcome::no_plan);
}

TEST(Rules, AGuardMayNeedTwoControlsAtOnce) {
  Builder b;
  b.control("arm", {"no", "yes"});
  b.control("fire", {"no", "yes"});
  b.component("pyro", {{"ready"}, {"fired"}});
  b.transition("ready", "fired", conjunction({b.is("arm", "yes"), b.is("fire", "yes")}));
  Craft craft(std::move(b));
  const auto answer = craft.next({"ready"}, craft.is("pyro", "fired"));
  EXPECT_EQ(craft.text(answer.action), "yes yes");
}

TEST(Rules, AGuardThatNothingCanBringAboutIsNoWay) {
  Builder b;
  b.variable("loose", {"no", "yes"});
  b.component("x", {{"off"}, {"on"}});
  b.transition("off", "on", b.is("loose", "yes"));
  b.transition("on", "off");
  Craft craft(std::move(b));
  EXPECT_EQ(craft.next({"off"}, craft.is("x", "on")).outcome, Outcome::no_plan);
}

TEST(Rules, WhatOneModelForcesIsNotRememberedForAnother) {
  // While the latch is held, all controls idle would contradict the model; what is sent then is not the lamp's way.
  Builder b;
  b.control("cmd", {"none", "free", "hold"});
  b.component("latch", {{"rest"}, {"held", b.is("cmd", "hold"), 0, true}});
  b.transition("held", "rest", b.is("cmd", "hold"));
  b.component("lamp", {{"on"}, {"out", automata::constant(true), 0, true}});
  b.transition("out", "on", automata::constant(true), std::pair(0, 1000));
  Craft craft(std::move(b));
  EXPECT_EQ(craft.text(craft.next({"held", "out"}, craft.is("lamp", "on")).action), "hold");
  EXPECT_EQ(craft.next({"rest", "out"}, craft.is("lamp", "on")).outcome, Outcome::wait);
}

TEST(Rules, AnImpossibleEstimateIsNoPlan) {
  Craft craft(crafts::propulsion());
  const auto answer = craft.next({"off", "closed", "closed", "full", "full", "firing"}, craft.is("engine", "off"));
  EXPECT_EQ(answer.outcome, Outcome::no_plan);
  EXPECT_EQ(answer.reason, "the estimated modes contradict each other");
}

}  // namespace
}  // namespace rmpl::runtime
