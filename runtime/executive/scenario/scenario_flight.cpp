// What a scenario and its options ask for, wired together.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/scenario_flight.hpp"

#include "base/error.hpp"
#include "runtime/executive/plant/scripted_plant.hpp"

namespace rmpl::runtime {
namespace {

std::unique_ptr<Clock> make_clock(const ScenarioOptions& options) {
  if (options.real_time) return std::make_unique<PacedClock>(options.interrupted);
  return std::make_unique<SimulatedClock>();
}

}  // namespace

ScenarioFlight::ScenarioFlight(const automata::Document& document, const automata::Scenario& scenario,
                               const ScenarioOptions& options)
    : program_(document.programs[scenario.program]) {
  if (scenario.cycle.count <= 0) {
    throw base::InputError("scenario '" + scenario.name + "': expected a cycle above 0 s");
  }
  engines_.emplace(document.plant_of(scenario), options, scenario.cycle);
  if (scenario.rules_only) {
    plant_ = std::make_unique<ScriptedPlant>(engines_->plant(), scenario);
  } else {
    plant_ = engines_->simulate(scenario, options.seed.value_or(scenario.seed));
  }
  clock_ = make_clock(options);
  commands_ = std::make_unique<CommandScript>(engines_->plant(), scenario);
  executive_ = std::make_unique<Executive>(program_, engines_->plant(), engines_->estimator(), engines_->reconfigurer(),
                                           *plant_, *clock_, scenario.cycle);
  if (!scenario.commands.empty()) executive_->obey(*commands_);
  if (options.measured) executive_->measure();
}

}  // namespace rmpl::runtime
