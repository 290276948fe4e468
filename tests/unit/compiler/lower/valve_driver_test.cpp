// Livingstone's valve driver: its transition system, mode by command, against the formulae of its Example 1.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "compiler/session/compiler.hpp"
#include "tests/paths.hpp"

namespace rmpl::compiler {
namespace {

using automata::Assignment;
using automata::ComponentId;
using automata::ModeId;
using automata::Ticks;
using automata::ValueId;

class ValveDriver : public ::testing::Test {
 protected:
  ValveDriver()
      : compilation_(
            compile(std::vector<std::string>{rmpl::paths::source() + "/examples/valve-driver/driver.tcca"}, {})),
        plant_(compilation_.document().plants.front()),
        step_(plant_) {}

  [[nodiscard]] std::string mode(std::size_t m) const { return plant_.components[0].modes[m].name; }
  [[nodiscard]] const std::vector<std::string>& commands() const {
    return plant_.variables[plant_.controls[0].variable].values;
  }
  /// Whether the driver's outputs can, or have to, be this under a command.
  bool output_is(std::size_t m, std::size_t command, const std::string& output) {
    const auto variable = *plant_.variables.find("driver.cmdout");
    const Assignment wanted{variable, *plant_.variables[variable].find(output)};
    const std::vector<Assignment> store{{plant_.components[0].mode, ValueId(m)},
                                        {plant_.controls[0].variable, ValueId(command)}};
    return !step_.theory().allows_other(store, wanted);
  }

  Compilation compilation_;
  const automata::Plant& plant_;
  automata::PlantStep step_;
};

/// The paper's nominal formulae, as a function; a mode that no formula speaks of persists.
std::string nominal_successor(const std::string& mode, const std::string& command) {
  if (mode == "failed") return "failed";
  if (command == "reset") return "on";
  if (mode == "resettable") return "resettable";
  if (command == "off") return "off";
  if (command == "on") return "on";
  return mode;
}

TEST_F(ValveDriver, HasTheTransitionsOfThePaper) {
  ASSERT_EQ(plant_.components[0].modes.size(), 4u);
  ASSERT_EQ(commands(), (std::vector<std::string>{"none", "on", "off", "reset", "open", "close"}));
  for (std::size_t m = 0; m < 4; ++m) {
    for (std::size_t u = 0; u < commands().size(); ++u) {
      const auto& enabled = step_.enabled({ModeId(m)}, {ValueId(u)})[0];
      const auto moves = step_.moves(ComponentId(0), ModeId(m), enabled, Ticks{0}, Ticks{0}, Ticks{1'000'000});
      std::set<std::string> successors;
      std::string likeliest;
      double most = 0;
      for (const automata::Move& move : moves) {
        successors.insert(mode(move.mode.index()));
        if (move.probability <= most) continue;
        most = move.probability;
        likeliest = mode(move.mode.index());
      }
      const std::string nominal = nominal_successor(mode(m), commands()[u]);
      EXPECT_EQ(likeliest, nominal) << mode(m) << " under " << commands()[u];
      EXPECT_EQ(successors, (std::set<std::string>{nominal, "failed", "resettable"}))
          << mode(m) << " under " << commands()[u];
    }
  }
}

TEST_F(ValveDriver, PassesCommandsOnWhileItIsOn) {
  for (std::size_t m = 0; m < 4; ++m) {
    for (std::size_t u = 0; u < commands().size(); ++u) {
      const std::string& command = commands()[u];
      for (const std::string output : {"none", "open", "close"}) {
        const bool passed = command == "open" || command == "close" ? output == command : output == "none";
        const bool expected = (mode(m) == "on" && passed) || (mode(m) == "off" && output == "none");
        EXPECT_EQ(output_is(m, u, output), expected) << mode(m) << " under " << command << ": " << output;
      }
    }
  }
}

}  // namespace
}  // namespace rmpl::compiler
