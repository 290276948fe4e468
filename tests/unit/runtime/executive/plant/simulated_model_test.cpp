// A model program as a simulated plant: same seed, same run; drawn as the model says.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "base/error.hpp"
#include "runtime/executive/plant/simulated_model.hpp"

namespace rmpl::runtime {
namespace {

using namespace rmpl::automata;

/// Location 2 goes to 3, 4 or 5 with 0.2, 0.3 and 0.5; 5 contradicts the constraint for the whole model. 3 entails x =
/// a, 4 leaves x open.
ModelProgram fork() {
  ModelProgram program;
  program.name = "Fork";
  const VariableId x = program.variables.add({"x", {"a", "b", "c"}});
  program.observables.push_back(x);
  program.constraints.emplace_back(negation(is(x, ValueId(2))));
  program.locations.resize(5);
  program.locations[0].composite = true;
  for (std::size_t l = 1; l < 5; ++l) {
    program.locations[l].parent = LocationId(0);
    if (l > 1) program.locations[l].functions.push_back({1, {}, {{{}, LocationId(l)}}});
  }
  program.locations[1].start = true;
  program.locations[1].functions = {
      {0.2, {}, {{{}, LocationId(2)}}}, {0.3, {}, {{{}, LocationId(3)}}}, {0.5, {}, {{{}, LocationId(4)}}}};
  program.locations[2].told = is(x, ValueId(0));
  program.locations[4].told = is(x, ValueId(2));
  return program;
}

TEST(SimulatedModel, DrawsAsTheModelSays) {
  const ModelProgram program = fork();
  constexpr int runs = 4000;
  int third = 0, open = 0, of_open = 0;
  for (std::uint64_t seed = 0; seed < runs; ++seed) {
    SimulatedModel plant(program, seed), again(program, seed);
    EXPECT_EQ(plant.marking(), (Marking{LocationId(0), LocationId(1)}));
    plant.step({});
    again.step({});
    ASSERT_EQ(plant.marking(), again.marking());
    const Observation seen = plant.read();
    ASSERT_EQ(seen, again.read());
    ASSERT_EQ(seen.size(), 1u);
    if (plant.marking().back() == LocationId(2)) {
      ++third;
      EXPECT_EQ(seen.front().value, ValueId(0));
    } else {
      ASSERT_EQ(plant.marking().back(), LocationId(3));
      ++open;
      of_open += seen.front().value == ValueId(0) ? 1 : 0;
    }
  }
  // What is impossible is drawn again: 0.2 to 0.3. Five standard deviations.
  EXPECT_NEAR(third / double{runs}, 0.4, 5 * std::sqrt(0.24 / runs));
  EXPECT_NEAR(of_open / static_cast<double>(open), 0.5, 5 * std::sqrt(0.25 / open));
}

TEST(SimulatedModel, SaysWhereNothingCanFollow) {
  ModelProgram program = fork();
  program.locations[1].functions = {{1, {}, {{{}, LocationId(4)}}}};
  SimulatedModel plant(program, 1);
  EXPECT_THROW(plant.step({}), base::InputError);
  program.locations[1].told = program.locations[4].told;
  EXPECT_THROW(SimulatedModel(program, 1), base::InputError);
}

}  // namespace
}  // namespace rmpl::runtime
