// Policies: Table 6.2 of the thesis, entry by entry, and the preconditions that its commands stand on.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/policy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/reasoning/reconfigure/causal_order.hpp"
#include "tests/unit/runtime/reasoning/reconfigure/reconfigure_models.hpp"

namespace rmpl::runtime {
namespace {

using automata::ComponentId;
using automata::Plant;
using ::testing::ElementsAre;

std::string text(const Plant& plant, const Precondition& precondition) {
  std::string result;
  for (const Requirement& r : precondition) {
    result += (result.empty() ? "" : " & ") + to_text(member(r.variable, r.values), plant.variables);
  }
  return result;
}

/// One entry the way Table 6.2 prints it; the table has Idle where nothing is to be done and where one waits.
std::string text(const Plant& plant, const PolicyEntry& entry) {
  switch (entry.kind) {
    case PolicyEntry::Kind::arrived:
    case PolicyEntry::Kind::wait:
      return "Idle";
    case PolicyEntry::Kind::command:
      return text(plant, entry.preconditions.front());
    case PolicyEntry::Kind::failure:
      return "Failure";
  }
  return "";
}

std::vector<std::string> row(const Plant& plant, const PolicyTable& table, std::size_t current) {
  std::vector<std::string> result;
  for (std::size_t target = 0; target < 4; ++target) result.push_back(text(plant, table.entries[current][target]));
  return result;
}

TEST(Policy, IsTable62ForTheEngine) {
  const Plant plant = crafts::bare_engine().plant;
  const PolicyTable table = policy_table(plant, *plant.find_component("engine"));
  const std::string standby = "ecmd = standby", off = "ecmd = off", idle = "Idle", failure = "Failure";
  EXPECT_THAT(row(plant, table, 0), ElementsAre(idle, standby, standby, standby));
  EXPECT_THAT(row(plant, table, 1), ElementsAre(off, idle, idle, idle));
  EXPECT_THAT(row(plant, table, 2), ElementsAre(off, off, idle, "ecmd = fire & valve1 = open & valve2 = open"));
  EXPECT_THAT(row(plant, table, 3), ElementsAre(standby, standby, standby, idle));
  EXPECT_THAT(row(plant, table, 4), ElementsAre(failure, failure, failure, failure));
}

TEST(Policy, CommandsPassThroughTheDriver) {
  const Plant plant = crafts::propulsion().plant;
  const auto valve = policy_table(plant, *plant.find_component("valve1"));
  EXPECT_EQ(text(plant, valve.entries[0][1]), "pde.cmd = open1 & pde = on");
  const auto engine = policy_table(plant, *plant.find_component("engine"));
  EXPECT_EQ(engine.entries[2][3].preconditions.size(), 1U);
  EXPECT_EQ(text(plant, engine.entries[2][3]),
            "pde.cmd = fireEngine & pde = on & valve1 in {open, stuck-open} & valve2 in {open, stuck-open} & "
            "tank1 = full & tank2 = full");
}

TEST(Policy, MarksWhatCannotBeUndone) {
  const Plant plant = crafts::lander().plant;
  const auto table = policy_table(plant, *plant.find_component("lander"));
  EXPECT_TRUE(table.entries[0][1].irreversible);
  EXPECT_EQ(table.entries[1][0].kind, PolicyEntry::Kind::failure);
  EXPECT_FALSE(policy_table(plant, ComponentId(0)).entries[0][2].irreversible);
}

TEST(CausalOrder, PutsTheDriverAfterWhatItDrives) {
  const Plant plant = crafts::propulsion().plant;
  const CausalOrder order(plant, NominalGraph(plant));
  std::vector<std::string> names;
  for (const ComponentId c : order.downstream_first()) names.push_back(plant[c].name);
  EXPECT_THAT(names, ElementsAre("engine", "valve1", "valve2", "pde", "tank1", "tank2"));
}

}  // namespace
}  // namespace rmpl::runtime
