// What a mode tells of an attribute stands in the place of the attribute.
// SPDX-License-Identifier: MIT
#include "automata/dependencies/known_attributes.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rmpl::automata {
namespace {

Mode mode(const char* name, Formula constraint) { return {name, false, std::move(constraint), 0, {}}; }

/// A timer tells whether it is over; a station asks that by its own name for it, and leaves where it is told to go or
/// has to.
class Station : public testing::Test {
 protected:
  Station() {
    over = plant.variables.add({"timer.over", {"no", "yes"}});
    due = plant.variables.add({"station.due", {"no", "yes"}});
    go = plant.variables.add({"station.go", {"stay", "leave"}});
    leaves = plant.variables.add({"station.leaves", {"no", "yes"}});
    const VariableId timer = plant.variables.add({"timer", {"run", "over"}});
    const VariableId station = plant.variables.add({"station", {"in", "out"}});
    plant.components.push_back({"timer",
                                "Timer",
                                timer,
                                {mode("run", is(over, ValueId(0))), mode("over", is(over, ValueId(1)))},
                                {1, 0},
                                {},
                                {}});
    plant.components.push_back(
        {"station",
         "Station",
         station,
         {mode("in", equivalence(is(leaves, ValueId(1)), disjunction({is(go, ValueId(1)), is(due, ValueId(1))}))),
          mode("out", is(leaves, ValueId(0)))},
         {1, 0},
         {},
         {}});
    plant.interconnections = {equality(due, over)};
    plant.controls = {{go, ValueId(0)}};
  }
  [[nodiscard]] std::vector<std::string> told(const KnownAttributes& known) const {
    std::vector<std::string> result;
    for (const Constraint& constraint : known.constraints()) {
      const std::string under =
          constraint.under ? to_text(is(constraint.under->variable, constraint.under->value), plant.variables) + ": "
                           : "";
      result.push_back(under + to_text(constraint.formula, plant.variables));
    }
    return result;
  }
  Plant plant;
  VariableId over, due, go, leaves;
};

TEST_F(Station, AsksTheModeInTheAttributesPlace) {
  const PlantIndex index(plant);
  const KnownAttributes known(plant, index, constraints_of(plant), {});
  EXPECT_EQ(told(known),
            (std::vector<std::string>{"timer = run: timer.over = no", "timer = over: timer.over = yes",
                                      "station = in: station.leaves = yes <-> station.go = leave | timer = over",
                                      "station = out: station.leaves = no", "timer = run: station.due = no",
                                      "timer = over: station.due = yes"}));
  EXPECT_EQ(to_text(known.rewritten(is(due, ValueId(1))), plant.variables), "timer = over");
  EXPECT_TRUE(known.rewritten(is(over, ValueId(1)), Assignment{plant.components[0].mode, ValueId(1)}).is_true());
}

TEST_F(Station, TellsWhatItDoesUnderACommandByItsOwnMode) {
  const PlantIndex index(plant);
  const Assignment leave{go, ValueId(1)};
  const KnownAttributes known(plant, index, constraints_of(plant), {&leave, 1});
  EXPECT_EQ(to_text(known.rewritten(is(leaves, ValueId(1))), plant.variables), "station = in");
}

}  // namespace
}  // namespace rmpl::automata
