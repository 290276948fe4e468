// Engines by options.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/engines.hpp"

#include "runtime/executive/plant/simulated_plant.hpp"
#include "runtime/reasoning/reconfigure/one_step.hpp"

namespace rmpl::runtime {
namespace {

std::unique_ptr<Estimator> make_estimator(automata::PlantStep& step, const ScenarioOptions& options) {
  EstimatorOptions estimator;
  estimator.k = options.k;
  estimator.live_clocks_only = true;
  switch (options.engine) {
    case ScenarioOptions::Engine::exact:
      return make_exact_estimator(step, estimator);
    case ScenarioOptions::Engine::k_best:
      return make_k_best_estimator(step, estimator);
  }
  return nullptr;
}

std::unique_ptr<Reconfigurer> make_recovery(automata::PlantStep& step, const ScenarioOptions& options,
                                            automata::Ticks cycle) {
  switch (options.recovery) {
    case ScenarioOptions::Recovery::planner:
      return make_reconfigurer(step, options.graph, cycle);
    case ScenarioOptions::Recovery::one_step:
      return make_one_step_reconfigurer(step, options.graph);
  }
  return nullptr;
}

}  // namespace

Engines::Engines(const automata::Plant& plant, const ScenarioOptions& options, automata::Ticks cycle)
    : plant_(plant),
      awaited_(options.awaited),
      luck_(options.luck),
      step_(plant),
      estimator_(make_estimator(step_, options)),
      reconfigurer_(make_recovery(step_, options, cycle)) {}

std::unique_ptr<PlantInterface> Engines::simulate(const automata::Scenario& scenario, std::uint64_t seed) {
  if (!flown_) flown_.emplace(plant_);
  return std::make_unique<SimulatedPlant>(*flown_, scenario, seed, awaited_, luck_);
}

}  // namespace rmpl::runtime
