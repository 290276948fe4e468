// A scenario: executive, plant and clock put together, and run to the verdict.
// SPDX-License-Identifier: MIT
#include "runtime/executive/scenario/run.hpp"

#include <algorithm>

#include "runtime/executive/scenario/scenario_flight.hpp"

namespace rmpl::runtime {

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
  ScenarioResult result;
  result.seed = options.seed.value_or(scenario.seed);
  ScenarioFlight flight(document, scenario, options);
  Expectations expectations(flight.engines().plant(), flight.engines().theory(), flight.program(), scenario);
  Executive& executive = flight.executive();
  PlantInterface& plant = flight.plant();
  const auto look = [&](const CycleRecord& record) {
    if (executive.ended() && !result.ended) result.ended = record.time;
    expectations.observe(record, executive.ended());
    for (CycleObserver* observer : observers) observer->observe(record);
  };
  const auto more_to_decide = [&] {
    return expectations.waiting() || (expectations.watching() && plant.more_to_come()) || plant.waits_for_occasion();
  };
  look(executive.record());
  while (executive.record().time < scenario.duration && (!executive.ended() || more_to_decide())) {
    result.interrupted = options.interrupted();
    if (result.interrupted) break;
    look(executive.run_cycle());
  }
  if (!result.interrupted) plant.finish(executive.record().time);
  result.cycles = executive.record().cycle;
  result.time = executive.record().time;
  expectations.close(executive.record(), result.interrupted);
  result.judgements = expectations.judgements();
  return result;
}

}  // namespace rmpl::runtime
