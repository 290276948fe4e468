// The quotients of one plant's dependencies, side by side.
// SPDX-License-Identifier: MIT
#include "automata/dependencies/dependencies.hpp"

#include <gtest/gtest.h>

namespace rmpl::automata {
namespace {

Mode mode(const char* name) { return {name, false, constant(true), 0, {}}; }

/// A driver passes its command on while it is open, to a valve whose guard reads it; the valve's flow is seen, and a
/// second command that only the valve's guard reads is not. A lamp stands apart.
class Pipe : public testing::Test {
 protected:
  Pipe() {
    command = plant.variables.add({"driver.cmd", {"none", "open"}});
    out = plant.variables.add({"driver.out", {"none", "open"}});
    in = plant.variables.add({"valve.in", {"none", "open"}});
    flow = plant.variables.add({"valve.flow", {"no", "yes"}});
    latch = plant.variables.add({"valve.latch", {"none", "pull"}});
    light = plant.variables.add({"lamp.light", {"off", "on"}});
    for (const char* name : {"driver", "valve", "lamp"}) {
      const VariableId variable = plant.variables.add({name, {"one", "two"}});
      plant.components.push_back({name, name, variable, {mode("one"), mode("two")}, {1, 0}, {}, {}});
    }
    plant.components[0].modes[0].constraint = equality(command, out);
    plant.components[1].modes[1].constraint = is(flow, ValueId(1));
    plant.components[2].modes[1].constraint = is(light, ValueId(1));
    plant.interconnections = {equality(out, in)};
    plant.components[1].transitions = {
        {ModeId(0u), ModeId(1u), conjunction({is(in, ValueId(1)), is(latch, ValueId(1))}), {}, {}, 0, {}}};
    plant.controls = {{command, ValueId(0)}, {latch, ValueId(0)}};
    plant.observables = {flow};
  }
  [[nodiscard]] VariableId mode_of(std::size_t component) const { return plant.components[component].mode; }
  Plant plant;
  VariableId command, out, in, flow, latch, light;
};

TEST_F(Pipe, IslandsKnowTheModes) {
  const Classes islands = Dependencies(plant).islands();
  EXPECT_EQ(islands.count, 4u);  // command, out and in; flow; latch; light
  EXPECT_EQ(islands[command], islands[in]);
  EXPECT_NE(islands[in], islands[flow]);
  EXPECT_FALSE(islands[mode_of(0)].has_value());
}

TEST_F(Pipe, RegionsKnowTheCommandsToo) {
  const Classes regions = Dependencies(plant).regions();
  EXPECT_EQ(regions.count, 3u);  // out and in; flow; light
  EXPECT_EQ(regions[out], regions[in]);
  EXPECT_FALSE(regions[command].has_value());
}

TEST_F(Pipe, PartsKnowNothing) {
  const Classes parts = Dependencies(plant).parts();
  EXPECT_EQ(parts.count, 2u);  // driver and valve; lamp
  EXPECT_EQ(parts[mode_of(0)], parts[mode_of(1)]);
  EXPECT_EQ(parts[latch], parts[flow]);
  EXPECT_NE(parts[mode_of(1)], parts[mode_of(2)]);
}

TEST_F(Pipe, GroupsKnowWhatIsOnlyCommanded) {
  const Dependencies dependencies(plant);
  const Classes groups = dependencies.groups();
  EXPECT_TRUE(dependencies.only_commanded(latch));
  EXPECT_FALSE(dependencies.only_commanded(command));  // the driver's constraint reads it
  EXPECT_FALSE(groups[latch].has_value());
  EXPECT_EQ(groups[mode_of(0)], groups[mode_of(1)]);
  EXPECT_EQ(groups.count, 2u);
}

}  // namespace
}  // namespace rmpl::automata
