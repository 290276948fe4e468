// A scenario put together: executive, plant and clock, to be flown cycle by cycle.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "automata/scenario.hpp"
#include "runtime/executive/cycle/clock.hpp"
#include "runtime/executive/cycle/command_script.hpp"
#include "runtime/executive/cycle/executive.hpp"
#include "runtime/executive/plant/plant_interface.hpp"
#include "runtime/executive/scenario/engines.hpp"
#include "runtime/executive/scenario/run.hpp"

namespace rmpl::runtime {

/// Same document, scenario and options: same flight. Keeps references to document and scenario.
class ScenarioFlight {
 public:
  /// Throws base::InputError where the cycle is not above 0, or the model leaves the simulated plant no state to be in.
  ScenarioFlight(const automata::Document& document, const automata::Scenario& scenario,
                 const ScenarioOptions& options);

  [[nodiscard]] const automata::Program& program() const { return program_; }
  [[nodiscard]] Engines& engines() { return *engines_; }
  [[nodiscard]] PlantInterface& plant() { return *plant_; }
  [[nodiscard]] Executive& executive() { return *executive_; }

 private:
  const automata::Program& program_;
  std::optional<Engines> engines_;
  std::unique_ptr<PlantInterface> plant_;
  std::unique_ptr<Clock> clock_;
  std::unique_ptr<CommandScript> commands_;
  std::unique_ptr<Executive> executive_;
};

}  // namespace rmpl::runtime
