// A scenario: executive, plant and clock put together, and run to the verdict.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/run.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "runtime/executive/cycle/clock.hpp"
#include "runtime/executive/cycle/executive.hpp"
#include "runtime/executive/plant/scripted_plant.hpp"
#include "runtime/executive/scenario/engines.hpp"

namespace rmpl::runtime {
namespace {

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
  const automata::Program& program = document.programs[scenario.program];
  if (scenario.cycle.count <= 0) {
    throw base::InputError("scenario '" + scenario.name + "': expected a cycle above 0 s");
  }
  ScenarioResult result;
  result.seed = options.seed.value_or(scenario.seed);

  const auto engines = scenario.model ? make_engines(document.models[*scenario.model], options)
                                      : make_engines(document.plants[scenario.plant], options);
  const std::unique_ptr<PlantInterface> plant = scenario.rules_only
                                                    ? std::make_unique<ScriptedPlant>(engines->model(), scenario)
                                                    : engines->simulate(scenario, result.seed);
  const auto clock = make_clock(options);
  Expectations expectations(engines->model(), engines->theory(), program, scenario);
  Executive executive(program, engines->model(), engines->estimator(), engines->reconfigurer(), *plant, *clock,
                      scenario.cycle);

  if (options.measured) executive.measure();
  const auto look = [&](const CycleRecord& record) {
    if (executive.ended() && !result.ended) result.ended = record.time;
    expectations.observe(record, executive.ended());
    for (CycleObserver* observer : observers) observer->observe(record);
  };
  const auto more_to_decide = [&] {
    return expectations.waiting() || (expectations.watching() && plant->more_to_come()) || plant->waits_for_occasion();
  };
  look(executive.record());
  while (executive.record().time < scenario.duration && (!executive.ended() || more_to_decide())) {
    result.interrupted = options.interrupted();
    if (result.interrupted) break;
    look(executive.run_cycle());
  }
  if (!result.interrupted) plant->finish(executive.record().time);
  result.cycles = executive.record().cycle;
  result.time = executive.record().time;
  expectations.close(executive.record(), result.interrupted);
  result.judgements = expectations.judgements();
  return result;
}

}  // namespace rmpl::runtime
