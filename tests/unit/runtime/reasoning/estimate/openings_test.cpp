// Who leaves a reading open, on a chain put together by hand.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/openings.hpp"

#include <gmock/gmock.h>

namespace rmpl::runtime {
namespace {

using automata::ComponentId;
using automata::ModeId;
using automata::Modes;
using automata::ValueId;
using automata::VariableId;
using testing::ElementsAre;

/// Two wires behind a supply that is on, each of which is good, cut or unknown; what leaves them is read.
class Chain : public testing::Test {
 protected:
  Chain() {
    VariableId before = plant.variables.add({"supply", {"off", "on"}});
    plant.interconnections.emplace_back(automata::is(before, ValueId(1)));
    for (const std::string name : {"first", "second"}) {
      const VariableId in = plant.variables.add({name + ".in", {"off", "on"}});
      const VariableId out = plant.variables.add({name + ".out", {"off", "on"}});
      const VariableId variable = plant.variables.add({name, {"good", "cut", "unknown"}});
      automata::Component wire{name, "Wire", variable, {}, {1, 0, 0}, {}, {}};
      wire.modes = {{"good", false, automata::equality(out, in), 0, {}},
                    {"cut", true, automata::is(out, ValueId(0)), 0, {}},
                    {"unknown", true, automata::constant(true), 0, {}}};
      plant.components.push_back(std::move(wire));
      plant.interconnections.emplace_back(automata::equality(before, in));
      plant.observables.push_back(out);
      before = out;
    }
  }
  static Modes modes(std::size_t first, std::size_t second) { return {ModeId(first), ModeId(second)}; }
  automata::Plant plant;
};

TEST_F(Chain, AnUnknownModeOpensWhatComesOutOfIt) {
  const Openings openings(plant);
  for (const std::size_t c : {0u, 1u}) {
    const Opening* const opening = openings.of({plant.observables[c], ValueId(0)});
    ASSERT_NE(opening, nullptr);
    EXPECT_EQ(opening->component, ComponentId(c));
    EXPECT_THAT(opening->modes, ElementsAre(false, false, true));
  }
}

TEST_F(Chain, ACopyIsOpenedByTheModesThatMakeItOne) {
  const Openings openings(plant);
  const automata::Assignment last{plant.observables[1], ValueId(0)};
  std::vector<ComponentId> components;
  EXPECT_TRUE(openings.opened_by(modes(2, 0), last, components));
  EXPECT_THAT(components, ElementsAre(ComponentId(0), ComponentId(1)));
  EXPECT_TRUE(openings.opened_by(modes(0, 2), last, components));
  EXPECT_THAT(components, ElementsAre(ComponentId(1)));
  EXPECT_FALSE(openings.opened_by(modes(2, 1), last, components)) << "it is no copy of what is unknown";
}

TEST_F(Chain, NoReadingCountsTwice) {
  const Openings openings(plant);
  const OpeningFactors factors(plant, openings,
                               {{plant.observables[0], ValueId(0)}, {plant.observables[1], ValueId(0)}});
  EXPECT_EQ(factors.of(0, ModeId(2u)) * factors.of(1, ModeId(2u)), 0.25);
  EXPECT_EQ(factors.of(0, ModeId(2u)) * factors.of(1, ModeId(0u)), 0.5);
  EXPECT_EQ(factors.of(0, ModeId(0u)) * factors.of(1, ModeId(1u)), 1.0);
}

TEST_F(Chain, NothingIsKnownWhereAValueMayBeWanting) {
  plant.interconnections.emplace_back(automata::is(plant.observables[1], ValueId(1)));
  const Openings openings(plant);
  EXPECT_EQ(openings.of({plant.observables[1], ValueId(1)}), nullptr);
}

}  // namespace
}  // namespace rmpl::runtime
