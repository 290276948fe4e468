// What is learnt from impossible states.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/nogoods.hpp"

#include <gtest/gtest.h>

#include "tests/unit/verifier/plants.hpp"

namespace rmpl::verifier {
namespace {

using automata::ComponentId;
using automata::ModeId;
using automata::Modes;
using automata::ValueId;
using test::PlantBuilder;

/// Three switches, of which the first two are never on together.
PlantBuilder switches() {
  PlantBuilder b;
  for (const char* name : {"a", "b", "c"}) b.component(name, {"off", "on"});
  const auto is_on = [&](std::size_t c) { return automata::is(b.plant.components[c].mode, ValueId(1)); };
  b.plant.interconnections.push_back(automata::negation(automata::conjunction({is_on(0), is_on(1)})));
  return b;
}

TEST(Nogoods, NameWhatCannotBeTogetherAndNothingElse) {
  const PlantBuilder b = switches();
  automata::PlantStep step(b.plant);
  Nogoods nogoods(step);
  PartialModes partial{{ModeId(1), ModeId(1), ModeId(0)}, {true, true, false}};
  EXPECT_FALSE(nogoods.refutes(partial, ComponentId(1))) << "nothing is learnt yet";

  EXPECT_TRUE(nogoods.possible({ModeId(1), ModeId(0), ModeId(1)}));
  EXPECT_FALSE(nogoods.possible({ModeId(1), ModeId(1), ModeId(1)}));
  EXPECT_TRUE(nogoods.refutes(partial, ComponentId(0))) << "the third switch is not to blame";
  EXPECT_TRUE(nogoods.refutes(partial, ComponentId(1)));
  EXPECT_FALSE(nogoods.refutes(partial, ComponentId(2)));
  partial.decided[0] = false;
  EXPECT_FALSE(nogoods.refutes(partial, ComponentId(1))) << "the first switch may still be off";
}

}  // namespace
}  // namespace rmpl::verifier
