// Islands and supports of a plant put together by hand.
// SPDX-License-Identifier: MIT
#include "automata/store/support.hpp"

#include <gtest/gtest.h>

namespace rmpl::automata {
namespace {

Mode mode(const char* name) { return {name, false, constant(true), 0, {}}; }

/// A switch feeds a lamp through a wire; a clock radio stands apart; one constraint speaks of modes alone.
class Room : public testing::Test {
 protected:
  Room() {
    lever = plant.variables.add({"switch.lever", {"none", "up"}});
    out = plant.variables.add({"switch.out", {"off", "on"}});
    in = plant.variables.add({"lamp.in", {"off", "on"}});
    sound = plant.variables.add({"radio.sound", {"off", "on"}});
    for (const char* name : {"switch", "lamp", "radio"}) {
      const VariableId variable = plant.variables.add({name, {"open", "shut", "dead"}});
      plant.components.push_back({name, name, variable, {mode("open"), mode("shut"), mode("dead")}, {1, 0, 0}, {}, {}});
    }
    plant.components[0].modes[0].constraint = is(out, ValueId(0));
    plant.components[2].modes[1].constraint = is(sound, ValueId(1));
    plant.interconnections = {equality(out, in), is(plant.components[2].mode, ValueId(0))};
    plant.controls = {{lever, ValueId(0)}};
  }
  Plant plant;
  VariableId lever, out, in, sound;
};

TEST_F(Room, AttributesThatShareAConstraintAreAnIsland) {
  const Locality locality(plant);
  EXPECT_EQ(locality.island_of(out), locality.island_of(in));
  EXPECT_NE(locality.island_of(out), locality.island_of(sound));
  EXPECT_NE(locality.island_of(out), locality.island_of(lever));
  EXPECT_FALSE(locality.island_of(plant.components[0].mode).has_value());
  // Lever, wire, sound, and the constraint on the radio's mode.
  ASSERT_EQ(locality.islands().size(), 4u);
  EXPECT_EQ(locality.islands().back().support, (Support{{ComponentId(2)}, {}}));
}

TEST_F(Room, AFormulaDependsOnWhatItsIslandsDependOn) {
  const Locality locality(plant);
  EXPECT_EQ(locality.support_of(is(in, ValueId(1))), (Support{{ComponentId(0)}, {}}));
  const Formula both = conjunction({is(in, ValueId(1)), is(lever, ValueId(1)), is(sound, ValueId(1))});
  EXPECT_EQ(locality.support_of(both), (Support{{ComponentId(0), ComponentId(2)}, {0}}));
  EXPECT_EQ(locality.support_of(is(plant.components[1].mode, ValueId(0))), (Support{{ComponentId(1)}, {}}));
}

TEST_F(Room, AProjectionTellsApartWhatItReadsAndNothingElse) {
  const Projection projection(plant, {{ComponentId(0), ComponentId(2)}, {0}});
  EXPECT_EQ(projection.bits(), 5u);
  const auto key = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t lever_value) {
    Projection::Key result;
    projection.read({ModeId(a), ModeId(b), ModeId(c)}, {ValueId(lever_value)}, result);
    return result;
  };
  EXPECT_EQ(key(1, 0, 2, 1), key(1, 2, 2, 1));
  EXPECT_NE(key(1, 0, 2, 1), key(1, 0, 2, 0));
  EXPECT_NE(key(1, 0, 2, 1), key(2, 0, 1, 1));
}

TEST(Projection, SpreadsOverWords) {
  Plant plant;
  for (int c = 0; c < 40; ++c) {
    const std::string name = "c" + std::to_string(c);
    const VariableId variable = plant.variables.add({name, {"a", "b", "c"}});
    plant.components.push_back({name, "C", variable, {mode("a"), mode("b"), mode("c")}, {1, 0, 0}, {}, {}});
  }
  Support all;
  for (std::size_t c = 0; c < 40; ++c) all.components.emplace_back(c);
  Modes modes(40);
  Projection::Key none, last;
  const Projection projection(plant, all);
  projection.read(modes, {}, none);
  EXPECT_EQ(none.size(), 2u);
  modes[39] = ModeId(2);
  projection.read(modes, {}, last);
  EXPECT_NE(none, last);
}

}  // namespace
}  // namespace rmpl::automata
