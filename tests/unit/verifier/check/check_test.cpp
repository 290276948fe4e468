// Properties of small plants, in both readings of time.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "tests/unit/verifier/plants.hpp"
#include "verifier/check/check.hpp"

namespace rmpl::verifier {
namespace {

using automata::Ticks;
using test::PlantBuilder;
using test::seconds;
using test::within;

Answer ask(const PlantBuilder& b, const Property& property, const CheckOptions& options = {}) {
  Slices slices(b.plant);
  return check(slices, property, options, {});
}

CheckOptions sampled(Ticks period) {
  CheckOptions options;
  options.period = period;
  return options;
}

Ticks half_second() { return {Ticks::per_second / 2}; }

Window by(Ticks time) { return {std::nullopt, time}; }
Window not_before(Ticks time) { return {time, std::nullopt}; }

TEST(Engine, ReachesStandbyInTwoStepsAfterThirtySeconds) {
  const auto b = test::engine();
  const Answer result = ask(b, Reachability{b.is("engine", "standby"), {}, false});
  ASSERT_EQ(result.verdict, Verdict::holds);
  ASSERT_EQ(result.witness->events.size(), 3u);
  EXPECT_EQ(result.witness->events[1].time, seconds(0));
  EXPECT_EQ(result.witness->events[2].time, seconds(30));
}

TEST(Engine, DenseBoundsAreExact) {
  const auto b = test::engine();
  const auto standby = b.is("engine", "standby");
  EXPECT_EQ(ask(b, Reachability{standby, by(seconds(30)), false}).verdict, Verdict::holds);
  EXPECT_EQ(ask(b, Reachability{standby, by(seconds(30) - Ticks{1}), false}).verdict, Verdict::violated);
  // Once heating, idle controls let it wait for 60 s and not a tick longer.
  CheckOptions heating;
  heating.commands = Commands::none;
  heating.from = {{b.plant.components[0].mode, automata::ValueId(1)}};
  const auto still = b.is("engine", "heating");
  EXPECT_EQ(ask(b, Reachability{still, not_before(seconds(60)), false}, heating).verdict, Verdict::holds);
  EXPECT_EQ(ask(b, Reachability{still, not_before(seconds(60) + Ticks{1}), false}, heating).verdict, Verdict::violated);
}

TEST(Engine, SampledBoundsAreThoseOfPositiveProbability) {
  const auto b = test::engine();
  const auto standby = b.is("engine", "standby");
  // Heating begins at 0.5 s at the earliest; its exit needs a period that ends after 30 s of it: at 31 s.
  EXPECT_EQ(ask(b, Reachability{standby, by(seconds(31)), false}, sampled(half_second())).verdict, Verdict::holds);
  EXPECT_EQ(ask(b, Reachability{standby, by(Ticks{30'999'999'999}), false}, sampled(half_second())).verdict,
            Verdict::violated);
  CheckOptions heating = sampled(half_second());
  heating.commands = Commands::none;
  heating.from = {{b.plant.components[0].mode, automata::ValueId(1)}};
  const auto still = b.is("engine", "heating");
  EXPECT_EQ(ask(b, Reachability{still, not_before(Ticks{59'500'000'000}), false}, heating).verdict, Verdict::holds);
  EXPECT_EQ(ask(b, Reachability{still, not_before(seconds(60)), false}, heating).verdict, Verdict::violated);
}

TEST(Engine, FaultsNeedABudget) {
  const auto b = test::engine();
  const auto failed = b.is("engine", "failed");
  CheckOptions one_fault;
  one_fault.faults = 1;
  EXPECT_EQ(ask(b, Safety{failed, {}, false}).verdict, Verdict::holds);
  const Answer broken = ask(b, Safety{failed, {}, false}, one_fault);
  EXPECT_EQ(broken.verdict, Verdict::violated);
  EXPECT_EQ(broken.witness->events.size(), 2u);
}

TEST(Engine, LongWaitsCostNothing) {
  const auto b = test::engine();
  for (const auto& options : {CheckOptions{}, sampled(half_second())}) {
    const Answer result = ask(b, Reachability{b.is("engine", "firing"), not_before(seconds(270 * 60)), false}, options);
    EXPECT_EQ(result.verdict, Verdict::holds);
    EXPECT_GE(result.witness->events.back().time, seconds(270 * 60));
    EXPECT_LT(result.progress.states, 50u);
  }
}

TEST(Engine, RespondsWithinItsUpperBound) {
  const auto b = test::engine();
  CheckOptions idle;
  idle.commands = Commands::none;
  idle.from = {{b.plant.components[0].mode, automata::ValueId(1)}};
  const auto response = [&](Ticks bound) {
    return Response{b.is("engine", "heating"), b.is("engine", "standby"), bound};
  };
  EXPECT_EQ(ask(b, response(seconds(60)), idle).verdict, Verdict::holds);
  const Answer missed = ask(b, response(seconds(59)), idle);
  EXPECT_EQ(missed.verdict, Verdict::violated);
  EXPECT_GT(missed.witness->events.back().time, seconds(59));
  // With commands, heating can be broken off.
  EXPECT_EQ(ask(b, response(seconds(60))).verdict, Verdict::violated);
}

TEST(Race, OnlyTheOverlapLetsTheSlowerWin) {
  for (const std::int64_t fast : {4, 5, 6}) {
    PlantBuilder b;
    auto& slow = b.component("slow", {"running", "done"});
    PlantBuilder::transition(slow, 0, 1, automata::constant(true), within(5, 9));
    auto& quick = b.component("quick", {"running", "done"});
    PlantBuilder::transition(quick, 0, 1, automata::constant(true), within(2, fast));
    const auto slow_first = automata::conjunction({b.is("slow", "done"), b.is("quick", "running")});
    EXPECT_EQ(ask(b, Safety{slow_first, {}, false}).verdict, fast < 5 ? Verdict::holds : Verdict::violated);
    // A period of 1 s: quick is certain in the period that ends at `fast`, slow possible in the one that ends at 6 s.
    EXPECT_EQ(ask(b, Safety{slow_first, {}, false}, sampled(seconds(1))).verdict,
              fast < 7 ? Verdict::holds : Verdict::violated);
  }
}

TEST(Fastest, TakesLessTimeInMoreSteps) {
  PlantBuilder b;
  auto& c = b.component("c", {"start", "slow", "quick", "quicker", "end"});
  PlantBuilder::transition(c, 0, 1, automata::constant(true), within(0, 1));
  PlantBuilder::transition(c, 1, 4, automata::constant(true), within(50, 60));
  PlantBuilder::transition(c, 0, 2, automata::constant(true), within(0, 1));
  PlantBuilder::transition(c, 2, 3, automata::constant(true), within(3, 4));
  PlantBuilder::transition(c, 3, 4, automata::constant(true), within(3, 4));
  const auto end = b.is("c", "end");
  EXPECT_EQ(ask(b, Reachability{end, {}, false}).witness->events.back().time, seconds(50));
  const Answer fastest = ask(b, Reachability{end, {}, true});
  EXPECT_EQ(fastest.witness->events.back().time, seconds(6));
  EXPECT_EQ(fastest.witness->events.size(), 4u);
}

TEST(Commands, HoldingACommandBlocksAnIdleExit) {
  // Under idle controls the valve springs back at once; a command held period by period keeps it open.
  PlantBuilder b;
  b.control("hold", {"no", "yes"});
  auto& valve = b.component("valve", {"closed", "open"});
  PlantBuilder::transition(valve, 0, 1, b.is("hold", "yes"));
  PlantBuilder::transition(valve, 1, 0, b.is("hold", "no"));
  const Reachability long_open{b.is("valve", "open"), not_before(seconds(1000)), false};
  const Response closes{b.is("valve", "open"), b.is("valve", "closed"), seconds(10)};
  EXPECT_EQ(ask(b, closes, sampled(seconds(1))).verdict, Verdict::violated);
  EXPECT_EQ(ask(b, closes).verdict, Verdict::holds);  // dense: no time passes while it could spring back
  EXPECT_EQ(ask(b, long_open, sampled(seconds(1))).verdict, Verdict::holds);
}

TEST(Attributes, AreAllowedOrEntailed) {
  PlantBuilder b;
  b.variable("flow", {"zero", "full"});
  auto& valve = b.component("valve", {"closed", "unknown!"});
  valve.modes[0].constraint = b.is("flow", "zero");
  PlantBuilder::transition(valve, 0, 1, automata::constant(true), {}, test::rate(1e-6));
  CheckOptions options;
  options.faults = 1;
  const Reachability flow{b.is("flow", "full"), {}, false};
  EXPECT_EQ(ask(b, flow).verdict, Verdict::violated);
  EXPECT_EQ(ask(b, flow, options).verdict, Verdict::holds);
  options.entailed = true;
  EXPECT_EQ(ask(b, flow, options).verdict, Verdict::violated);
}

TEST(Limits, AreSaid) {
  const auto b = test::engine();
  Slices slices(b.plant);
  Limits limits;
  limits.states = 1;
  CheckOptions one_fault;
  one_fault.faults = 1;
  const Answer result = check(slices, Safety{b.is("engine", "failed"), {}, false}, one_fault, limits);
  EXPECT_EQ(result.verdict, Verdict::undecided);
  EXPECT_EQ(result.limit, Limit::states);
  const std::atomic<bool> interrupted = true;
  limits = {};
  limits.interrupted = &interrupted;
  EXPECT_EQ(check(slices, Reachability{b.is("engine", "firing"), {}, false}, {}, limits).limit, Limit::interrupt);
}

TEST(Planned, RunsStandInForASearchThatComesToManyStates) {
  const auto b = test::engine();
  Slices slices(b.plant);
  CheckOptions options;
  options.states_before_plan = options.components_for_plan = 0;
  const Reachability standby{b.is("engine", "standby"), {}, false};
  const Answer planned = check(slices, standby, options, {});
  EXPECT_EQ(planned.verdict, Verdict::holds);
  EXPECT_EQ(planned.limit, Limit::plan);
  EXPECT_EQ(planned.witness->events.back().time, seconds(30));
  // No plan leads to a fault: the search goes on.
  options.faults = 1;
  const Answer failed = check(slices, Safety{b.is("engine", "failed"), {}, false}, options, {});
  EXPECT_EQ(failed.verdict, Verdict::violated);
  EXPECT_FALSE(failed.limit);
}

TEST(Planned, RunsStandInForASearchThatWasGivenUp) {
  const auto b = test::engine();
  Slices slices(b.plant);
  Limits limits;
  limits.states = 1;
  const Reachability standby{b.is("engine", "standby"), {}, false};
  const Answer dense = check(slices, standby, {}, limits);
  ASSERT_EQ(dense.verdict, Verdict::holds);
  EXPECT_EQ(dense.limit, Limit::states);
  EXPECT_EQ(dense.witness->events.back().time, seconds(30));
  // Too soon for the heating, which takes half a minute: seen without a search.
  const Answer late = check(slices, Reachability{standby.target, by(seconds(29)), false}, {}, limits);
  EXPECT_EQ(late.verdict, Verdict::violated);
  const Answer waits = check(slices, Reachability{standby.target, not_before(seconds(90)), false}, {}, limits);
  EXPECT_EQ(waits.verdict, Verdict::holds);
  EXPECT_EQ(waits.witness->events.back().time, seconds(90));
  const Answer steps = check(slices, standby, sampled(half_second()), limits);
  ASSERT_EQ(steps.verdict, Verdict::holds);
  EXPECT_EQ(steps.witness->events.back().time, seconds(31));
}

TEST(From, HasToNameEachModeOnce) {
  const auto b = test::engine();
  CheckOptions options;
  options.from = {{b.plant.controls[0].variable, automata::ValueId(0)}};
  EXPECT_THROW(ask(b, Safety{b.is("engine", "off"), {}, false}, options), base::InputError);
  const automata::VariableId mode = b.plant.components[0].mode;
  options.from = {{mode, automata::ValueId(0)}, {mode, automata::ValueId(1)}};
  EXPECT_THROW(ask(b, Safety{b.is("engine", "off"), {}, false}, options), base::InputError);
}

/// A command that contradicts the interconnections enables everything, wherever it is.
TEST(Slices, KeepWhatACommandContradicts) {
  PlantBuilder b;
  b.control("stray", {"none", "forbidden"});
  b.variable("x", {"zero", "one"});
  b.plant.interconnections.emplace_back(b.is("stray", "none"));
  auto& valve = b.component("valve", {"closed", "open"});
  b.transition(valve, 0, 1, b.is("x", "one"));
  b.component("other", {"here", "there"});
  const Answer result = ask(b, Reachability{b.is("valve", "open"), {}, false});
  ASSERT_EQ(result.verdict, Verdict::holds);
  EXPECT_EQ(result.witness->events.back().action.front(), automata::ValueId(1));
  EXPECT_EQ(result.witness->events.back().modes.size(), 2u);
}

TEST(OutOfReach, AFaultWithoutABudgetIsToldAtOnce) {
  const auto b = test::engine();
  const Safety safety{b.is("engine", "failed"), {}, false};
  const Answer result = ask(b, safety);
  EXPECT_EQ(result.verdict, Verdict::holds);
  EXPECT_EQ(result.progress.states, 0u);
  CheckOptions one;
  one.faults = 1;
  EXPECT_EQ(ask(b, safety, one).verdict, Verdict::violated);
}

}  // namespace
}  // namespace rmpl::verifier
