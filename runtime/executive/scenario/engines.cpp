// Plants of components, and model programs.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/engines.hpp"

#include <optional>

#include "automata/step/marked_plant.hpp"
#include "automata/store/model.hpp"
#include "base/error.hpp"
#include "runtime/executive/plant/simulated_plant.hpp"
#include "runtime/executive/plant/simulated_software.hpp"
#include "runtime/reasoning/estimate/marking/marked_estimator.hpp"
#include "runtime/reasoning/reconfigure/marked_reconfigurer.hpp"
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

class PlantEngines final : public Engines {
 public:
  PlantEngines(const automata::Plant& plant, const ScenarioOptions& options, automata::Ticks cycle)
      : plant_(plant), awaited_(options.awaited), luck_(options.luck), step_(plant) {
    estimator_ = make_estimator(step_, options);
    reconfigurer_ = make_recovery(step_, options, cycle);
  }

  [[nodiscard]] const automata::Plant& model() const override { return plant_; }
  [[nodiscard]] automata::Theory& theory() override { return step_.theory(); }
  [[nodiscard]] std::unique_ptr<PlantInterface> simulate(const automata::Scenario& scenario,
                                                         std::uint64_t seed) override {
    if (!flown_) flown_.emplace(plant_);
    return std::make_unique<SimulatedPlant>(*flown_, scenario, seed, awaited_, luck_);
  }

 private:
  const automata::Plant& plant_;
  std::vector<automata::ForcedMode> awaited_;
  LuckUse luck_;
  automata::PlantStep step_;
  std::optional<automata::PlantStep> flown_;  ///< of the simulated plant, which shares no memory with the estimator
};

MarkingOptions marking_options(const ScenarioOptions& options) {
  MarkingOptions result;
  result.kind =
      options.engine == ScenarioOptions::Engine::exact ? MarkingOptions::Kind::exact : MarkingOptions::Kind::k_best;
  result.k = options.k;
  result.listed = options.k;
  return result;
}

class SoftwareEngines final : public Engines {
 public:
  SoftwareEngines(const automata::ModelProgram& program, const ScenarioOptions& options)
      : program_(program), plant_(program), theory_(automata::model_theory(plant_.plant())) {
    estimator_ = make_marked_estimator(program, plant_, marking_options(options));
    reconfigurer_ = make_marked_reconfigurer(program, plant_);
  }

  [[nodiscard]] const automata::Plant& model() const override { return plant_.plant(); }
  [[nodiscard]] automata::Theory& theory() override { return theory_; }
  [[nodiscard]] std::unique_ptr<PlantInterface> simulate(const automata::Scenario& scenario,
                                                         std::uint64_t seed) override {
    return std::make_unique<SimulatedSoftware>(program_, plant_, scenario, seed);
  }

 private:
  const automata::ModelProgram& program_;
  automata::MarkedPlant plant_;
  automata::Theory theory_;
};

}  // namespace

std::unique_ptr<Engines> make_engines(const automata::Plant& plant, const ScenarioOptions& options,
                                      automata::Ticks cycle) {
  return std::make_unique<PlantEngines>(plant, options, cycle);
}

std::unique_ptr<Engines> make_engines(const automata::ModelProgram& program, const ScenarioOptions& options) {
  if (options.recovery == ScenarioOptions::Recovery::one_step) {
    throw base::InputError("--reconfigurer one-step: '" + program.name +
                           "' is a model program, which is planned for over its markings");
  }
  return std::make_unique<SoftwareEngines>(program, options);
}

}  // namespace rmpl::runtime
