// Automorphisms of small plants, and states sorted by them.
// SPDX-License-Identifier: MIT
#include "verifier/symmetry/symmetry.hpp"

#include <gtest/gtest.h>

#include "tests/unit/verifier/plants.hpp"

namespace rmpl::verifier {
namespace {

using automata::ComponentId;
using automata::ModeId;
using automata::Modes;
using test::PlantBuilder;
using test::within;

/// Three like components, and one whose modes name one of them each.
PlantBuilder three_and_a_pointer() {
  PlantBuilder b;
  for (const char* name : {"a", "b", "c"}) {
    auto& component = b.component(name, {"off", "on"});
    PlantBuilder::transition(component, 0, 1, automata::constant(true), within(1, 2));
  }
  const auto is_on = [&](std::size_t c) { return automata::is(b.plant.components[c].mode, automata::ValueId(1)); };
  auto& pointer = b.component("pointer", {"nobody", "at_a", "at_b", "at_c"});
  for (std::size_t c = 0; c < 3; ++c) PlantBuilder::transition(pointer, 0, c + 1, is_on(c));
  return b;
}

Modes modes(std::initializer_list<std::size_t> values) {
  Modes result;
  for (const std::size_t v : values) result.emplace_back(v);
  return result;
}

TEST(Automorphisms, RenameValuesWithTheComponentsThatTheyNameAfter) {
  const PlantBuilder b = three_and_a_pointer();
  const auto generators = automorphisms(b.plant, {}, {});
  ASSERT_FALSE(generators.empty());
  for (const Permutation& g : generators) {
    // Whoever the pointer is at goes along.
    const Modes at_a = renamed(modes({1, 0, 0, 1}), g);
    EXPECT_EQ(at_a[at_a[3].index() - 1], ModeId(1));
    EXPECT_EQ(composed(g, inverse(g)), Permutation{});
  }
}

TEST(Automorphisms, KeepTheQuestionTheStartAndTheBounds) {
  PlantBuilder b = three_and_a_pointer();
  const auto is_on = [&](std::size_t c) { return automata::is(b.plant.components[c].mode, automata::ValueId(1)); };
  EXPECT_EQ(automorphisms(b.plant, {automata::conjunction({is_on(0), is_on(1)})}, {}).size(), 1u);
  EXPECT_EQ(automorphisms(b.plant, {}, {{b.plant.components[2].mode, automata::ValueId(1)}}).size(), 1u);
  b.plant.components[1].transitions[0].timing = within(1, 3);
  EXPECT_EQ(automorphisms(b.plant, {}, {}).size(), 1u);
  b.plant.components[2].modes[1].fault = true;
  EXPECT_TRUE(automorphisms(b.plant, {}, {}).empty());
}

TEST(Symmetry, SortsModesAndClocks) {
  const PlantBuilder b = three_and_a_pointer();
  const Symmetry symmetry(automorphisms(b.plant, {}, {}));
  Zone zone(2);
  ASSERT_TRUE(zone.constrain(0, 0, 0));
  zone.elapse();
  ASSERT_TRUE(zone.constrain(1, Interval{5, 5}));
  // b is on and pointed at; a and c are off, a's clock having been restarted later.
  const std::vector<std::size_t> restarted = {0, 2};
  zone = zone.select(restarted);
  Modes state = modes({0, 1, 0, 2});
  std::vector<ComponentId> live = {ComponentId(0), ComponentId(2)};
  const Permutation applied = symmetry.sort(state, live, 0, zone, true);
  EXPECT_EQ(state, modes({0, 0, 1, 3}));
  EXPECT_EQ(renamed(modes({0, 1, 0, 2}), applied), state);
  EXPECT_EQ(live, (std::vector<ComponentId>{ComponentId(0), ComponentId(1)}));
  EXPECT_EQ(zone.lower(1), 5);
  EXPECT_EQ(zone.lower(2), 0);
}

}  // namespace
}  // namespace rmpl::verifier
