// A scenario: executive, plant and clock put together, and run to the verdict.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/run.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "runtime/executive/cycle/clock.hpp"
#include "runtime/executive/cycle/executive.hpp"
#include "runtime/executive/plant/scripted_plant.hpp"
#include "runtime/executive/plant/simulated_plant.hpp"
#include "runtime/executive/scenario/engines.hpp"

namespace rmpl::runtime {
namespace {

std::unique_ptr<PlantInterface> make_plant(const automata::Plant& model, const automata::Scenario& scenario,
                                           std::uint64_t seed, const ScenarioOptions& options) {
  if (scenario.rules_only) return std::make_unique<ScriptedPlant>(model, scenario);
  return std::make_unique<SimulatedPlant>(model, scenario, seed, options.awaited);
}

std::unique_ptr<Clock> make_clock(const ScenarioOptions& options) {
  if (options.real_time) return std::make_unique<PacedClock>(options.interrupted);
  return std::make_unique<SimulatedClock>();
}

}  // namespace

Judgement::Verdict ScenarioResult::verdict() const {
  const auto some = [&](Judgement::Verdict verdict) {
    return std::any_of(judgements.begin(), judgements.end(), [&](const auto& j) { return j.verdict == verdict; });
  };
  if (some(Judgement::Verdict::failed)) return Judgement::Verdict::failed;
  if (interrupted || some(Judgement::Verdict::undecided)) return Judgement::Verdict::undecided;
  return Judgement::Verdict::met;
}

ScenarioResult run_scenario(const automata::Document& document, const automata::Scenario& scenario,
                            const ScenarioOptions& options, const std::vector<CycleObserver*>& observers) {
  const automata::Plant& model = document.plants[scenario.plant];
  const automata::Program& program = document.programs[scenario.program];
  if (scenario.cycle.count <= 0) {
    throw base::InputError("scenario '" + scenario.name + "': expected a cycle above 0 s");
  }
  ScenarioResult result;
  result.seed = options.seed.value_or(scenario.seed);

  automata::PlantStep step(model);
  const auto estimator = make_estimator(step, options);
  const auto reconfigurer = make_recovery(step, options);
  const auto plant = make_plant(model, scenario, result.seed, options);
  const auto clock = make_clock(options);
  Expectations expectations(step, program, scenario);
  Executive executive(program, model, *estimator, *reconfigurer, *plant, *clock, scenario.cycle);

  if (options.measured) executive.measure();
  const auto look = [&](const CycleRecord& record) {
    if (executive.ended() && !result.ended) result.ended = record.time;
    expectations.observe(record, executive.ended());
    for (CycleObserver* observer : observers) observer->observe(record);
  };
  const auto more_to_decide = [&] {
    return expectations.waiting() || (expectations.watching() && plant->more_to_come());
  };
  look(executive.record());
  while (executive.record().time < scenario.duration && (!executive.ended() || more_to_decide())) {
    result.interrupted = options.interrupted();
    if (result.interrupted) break;
    look(executive.run_cycle());
  }
  result.cycles = executive.record().cycle;
  result.time = executive.record().time;
  expectations.close(executive.record(), result.interrupted);
  result.judgements = expectations.judgements();
  return result;
}

}  // namespace rmpl::runtime
