// One engine or the other.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/engines.hpp"

#include "runtime/reasoning/reconfigure/one_step.hpp"

namespace rmpl::runtime {

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

std::unique_ptr<Reconfigurer> make_recovery(automata::PlantStep& step, const ScenarioOptions& options) {
  switch (options.recovery) {
    case ScenarioOptions::Recovery::planner:
      return make_reconfigurer(step, options.graph);
    case ScenarioOptions::Recovery::one_step:
      return make_one_step_reconfigurer(step, options.graph);
  }
  return nullptr;
}

}  // namespace rmpl::runtime
