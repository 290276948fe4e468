// Fig. 5-3, rule by rule, on programs of a few locations. The walk of thesis 5.4 is a test of the sequencer.
// SPDX-License-Identifier: MIT
#include "automata/step/program_step.hpp"

#include <gtest/gtest.h>

namespace rmpl::automata {
namespace {

Ticks s(double seconds) { return *ticks_from_seconds(seconds); }

class ProgramSteps : public testing::Test {
 protected:
  ProgramSteps() {
    x = program.variables.add({"x", {"off", "on", "bad"}});
    y = program.variables.add({"y", {"off", "on"}});
    program.locations.emplace_back().composite = true;
  }
  LocationId add(std::size_t parent, bool start, std::vector<Assignment> goal = {}, bool composite = false) {
    Location location;
    location.composite = composite;
    location.parent = LocationId(parent - 1);
    location.start = start;
    location.goal = std::move(goal);
    program.locations.push_back(std::move(location));
    return LocationId(program.locations.size() - 1);
  }
  Location& at(std::size_t number) { return program.locations[number - 1]; }
  static LocationId to(std::size_t number) { return LocationId(number - 1); }
  Knowledge know(std::size_t x_value, std::size_t y_value) const {
    return {{{x, ValueId(x_value)}, {y, ValueId(y_value)}}};
  }
  static std::vector<std::size_t> numbers(const ProgramStep& step) {
    std::vector<std::size_t> all;
    for (const LocationId id : step.marking()) all.push_back(id.index() + 1);
    return all;
  }
  using Numbers = std::vector<std::size_t>;

  Program program;
  VariableId x, y;
};

TEST_F(ProgramSteps, AGoalWaitsUntilItIsAchieved) {
  add(1, true, {{x, ValueId(1)}});
  add(1, false, {{y, ValueId(1)}});
  at(2).arcs.push_back({{}, to(3)});
  ProgramStep step(program);
  EXPECT_EQ(numbers(step), (Numbers{1, 2}));
  EXPECT_EQ(step.begin(know(0, 0), s(0)).goal, (std::vector<Assignment>{{x, ValueId(1)}}));
  step.finish(know(0, 0));
  EXPECT_EQ(numbers(step), (Numbers{1, 2}));
  step.begin(know(0, 0), s(1));
  step.finish(know(1, 0));
  EXPECT_EQ(numbers(step), (Numbers{1, 3}));
  EXPECT_EQ(step.begin(know(1, 0), s(2)).goal, (std::vector<Assignment>{{y, ValueId(1)}}));
  step.finish(know(1, 1));
  EXPECT_TRUE(step.ended());
}

TEST_F(ProgramSteps, PreemptionUnmarksWhatIsInsideAndTakesTheExit) {
  add(1, true, {}, true);            // 2: do … watching x = bad
  add(2, true, {{x, ValueId(1)}});   // 3
  add(1, false, {{y, ValueId(1)}});  // 4
  at(2).maintenance = {false, is(x, ValueId(2))};
  at(2).arcs.push_back({{}, to(4)});
  at(3).arcs.push_back({{}, to(3)});
  ProgramStep step(program);
  EXPECT_EQ(numbers(step), (Numbers{1, 2, 3}));
  step.begin(know(0, 0), s(0));
  step.finish(know(2, 0));  // noticed at the start of the next cycle
  EXPECT_EQ(numbers(step), (Numbers{1, 2, 3}));
  EXPECT_TRUE(step.begin(know(2, 0), s(1)).goal.empty());
  step.finish(know(2, 0));
  EXPECT_EQ(numbers(step), (Numbers{1, 4}));
}

TEST_F(ProgramSteps, ACompositeExitsWhenNothingInsideGoesOn) {
  add(1, true, {}, true);           // 2: { 3 , 4 }
  add(2, true, {{x, ValueId(1)}});  // 3
  add(2, true, {{y, ValueId(1)}});  // 4
  add(1, false);                    // 5
  at(2).arcs.push_back({{}, to(5)});
  ProgramStep step(program);
  step.begin(know(0, 0), s(0));
  step.finish(know(1, 0));
  EXPECT_EQ(numbers(step), (Numbers{1, 2, 4}));
  step.begin(know(1, 0), s(1));
  step.finish(know(1, 1));
  EXPECT_EQ(numbers(step), (Numbers{1, 5}));
}

TEST_F(ProgramSteps, AClockKeepsItsStart) {
  program.clocks.push_back("t");
  add(1, true);  // 2: t = 0, for ever re-marked
  at(2).clock_start = ClockId(0);
  at(2).arcs.push_back({{}, to(2)});
  ProgramStep step(program);
  step.begin(know(0, 0), s(3));
  EXPECT_FALSE(step.clocks()[0]);
  step.finish(know(0, 0));
  step.begin(know(0, 0), s(4));
  EXPECT_EQ(step.clocks()[0], s(1));
  step.finish(know(0, 0));
  step.begin(know(0, 0), s(6));
  EXPECT_EQ(step.clocks()[0], s(3));
}

TEST_F(ProgramSteps, ClockGuardsReadTheClocksOfTheirCycle) {
  program.clocks.push_back("t");
  add(1, true);   // 2: t = 0
  add(1, false);  // 3: when t >= 2
  at(2).clock_start = ClockId(0);
  at(2).arcs.push_back({{}, to(3)});
  const Formula late = clock_bound(ClockId(0), Comparison::at_least, s(2));
  at(3).arcs.push_back({{false, late}, to(3)});
  add(1, false, {{x, ValueId(1)}});
  at(3).arcs.push_back({{true, late}, to(4)});
  ProgramStep step(program);
  for (const double now : {0.0, 1.0}) {
    step.begin(know(0, 0), s(now));
    step.finish(know(0, 0));
    EXPECT_EQ(numbers(step), (Numbers{1, 3})) << now;
  }
  step.begin(know(0, 0), s(2));
  step.finish(know(0, 0));
  EXPECT_EQ(numbers(step), (Numbers{1, 4}));
}

TEST_F(ProgramSteps, ContradictingGoalsAreReportedWithBothLocations) {
  add(1, true, {{x, ValueId(0)}});
  add(1, true, {{y, ValueId(1)}, {x, ValueId(1)}});
  ProgramStep step(program);
  const auto& asserted = step.begin(know(0, 0), s(0));
  ASSERT_EQ(asserted.conflicts.size(), 1u);
  EXPECT_EQ(asserted.conflicts[0].first, to(2));
  EXPECT_EQ(asserted.conflicts[0].second, to(3));
}

TEST_F(ProgramSteps, NonEntailmentIsNotEntailmentOfTheNegation) {
  add(1, true);
  add(1, false);
  at(2).arcs.push_back({{false, is(x, ValueId(1))}, to(3)});
  ProgramStep step(program);
  step.begin({}, s(0));
  step.finish({});  // nothing is known of x
  EXPECT_EQ(numbers(step), (Numbers{1, 3}));
}

}  // namespace
}  // namespace rmpl::automata
