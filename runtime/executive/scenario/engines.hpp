// What an executive is put together from, by what a command line says of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/scenario.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/executive/plant/plant_interface.hpp"
#include "runtime/executive/scenario/run.hpp"

namespace rmpl::runtime {

/// Mode estimation as the executive uses it (the clock of a mode without a timed exit is forgotten), reconfiguration,
/// and what their plant looks like from outside.
class Engines {
 public:
  /// Keeps a reference to the plant. `cycle`: of the executive.
  Engines(const automata::Plant& plant, const ScenarioOptions& options, automata::Ticks cycle);
  Engines(const Engines&) = delete;
  Engines& operator=(const Engines&) = delete;

  [[nodiscard]] const automata::Plant& plant() const { return plant_; }
  /// Of the plant.
  [[nodiscard]] automata::Theory& theory() { return step_.theory(); }
  [[nodiscard]] Estimator& estimator() { return *estimator_; }
  [[nodiscard]] Reconfigurer& reconfigurer() { return *reconfigurer_; }
  /// A plant that behaves as the model says, by chance, with what the scenario has in store.
  [[nodiscard]] std::unique_ptr<PlantInterface> simulate(const automata::Scenario& scenario, std::uint64_t seed);

 private:
  const automata::Plant& plant_;
  std::vector<automata::ForcedMode> awaited_;
  LuckUse luck_;
  automata::PlantStep step_;
  std::optional<automata::PlantStep> flown_;  ///< of the simulated plant, which shares no memory with the estimator
  std::unique_ptr<Estimator> estimator_;
  std::unique_ptr<Reconfigurer> reconfigurer_;
};

}  // namespace rmpl::runtime
