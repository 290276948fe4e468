// A run of the closed loop is replayed as it was found; whatever of it is falsified, it is refused.
// SPDX-License-Identifier: MIT
#include "verifier/witness/loop_replay.hpp"

#include <gtest/gtest.h>

#include "tests/unit/verifier/plants.hpp"
#include "verifier/closed_loop/check.hpp"

namespace rmpl::verifier {
namespace {

using automata::ModeId;
using automata::Ticks;
using automata::ValueId;
using test::seconds;

/// Asks for the engine's standby over and over.
automata::Program standby(const test::PlantBuilder& engine) {
  automata::Program result;
  result.variables = engine.plant.variables;
  result.locations.resize(2);
  result.locations[0].composite = true;
  result.locations[1].parent = automata::LocationId(0);
  result.locations[1].start = true;
  result.locations[1].goal = {{engine.plant.components[0].mode, ValueId(2)}};
  result.locations[1].arcs = {{{}, automata::LocationId(1)}};
  return result;
}

/// Off at 0, heating under a command, standby at 30 s.
class ReplayLoop : public testing::Test {
 protected:
  void SetUp() override {
    const ProgramProperty never{ProgramProperty::Kind::never, engine_.is("engine", "standby")};
    automata::PlantStep searched(engine_.plant);
    const auto answers = check(program_, searched, {never}, {}, {});
    ASSERT_TRUE(answers.front().witness);
    witness_ = *answers.front().witness;
    ASSERT_EQ(witness_.events.size(), 4U);
  }
  std::string failure() { return judge_.replay(witness_, {}).value_or(""); }

  test::PlantBuilder engine_ = test::engine();
  automata::Program program_ = standby(engine_);
  LoopJudge judge_{program_, engine_.plant, runtime::reconfiguration_graph(engine_.plant)};
  Witness witness_;
};

TEST_F(ReplayLoop, PassesAsItWasFound) { EXPECT_EQ(failure(), ""); }

TEST_F(ReplayLoop, RefusesAnotherStart) {
  witness_.events[0].modes = {ModeId(1)};
  EXPECT_EQ(failure(), "engine does not start so");
}

TEST_F(ReplayLoop, RefusesAnotherTime) {
  Event& ready = witness_.events[2];
  ready.time = ready.cycle->begin = seconds(30) - Ticks{1};
  EXPECT_EQ(failure(), "the step is not possible at 29.999999999 s");
  ready.time = ready.cycle->begin = seconds(60) + Ticks{1};
  EXPECT_EQ(failure(), "nothing changing is not possible at 0.000000001 s");
}

TEST_F(ReplayLoop, RefusesAnotherMode) {
  witness_.events[2].modes = {ModeId(3)};
  EXPECT_EQ(failure(), "the step is not possible at 30 s");
}

TEST_F(ReplayLoop, RefusesAnotherCommand) {
  witness_.events[1].action = {ValueId(3)};
  EXPECT_EQ(failure(), "another command at 0 s");
}

TEST_F(ReplayLoop, RefusesAnotherGoalAndAnotherMarking) {
  Witness right = witness_;
  witness_.events[1].cycle->goals.goal.clear();
  EXPECT_EQ(failure(), "another goal at 0 s");
  witness_ = right;
  witness_.events[1].cycle->marking.clear();
  EXPECT_EQ(failure(), "another marking at 0 s");
}

}  // namespace
}  // namespace rmpl::verifier
