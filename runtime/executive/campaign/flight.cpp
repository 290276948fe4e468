// Flies a scenario with injected faults, and observes it.
// SPDX-License-Identifier: MIT
#include "runtime/executive/campaign/flight.hpp"

#include <algorithm>
#include <string>

#include "base/check.hpp"
#include "base/error.hpp"

namespace rmpl::runtime {
namespace {

CampaignRun::Verdict verdict_of(Judgement::Verdict verdict) {
  switch (verdict) {
    case Judgement::Verdict::met:
      return CampaignRun::Verdict::met;
    case Judgement::Verdict::failed:
      return CampaignRun::Verdict::failed;
    case Judgement::Verdict::undecided:
      return CampaignRun::Verdict::undecided;
  }
  return CampaignRun::Verdict::undecided;
}

}  // namespace

std::string_view name_of(CampaignRun::Verdict verdict) {
  switch (verdict) {
    case CampaignRun::Verdict::met:
      return "met";
    case CampaignRun::Verdict::failed:
      return "failed";
    case CampaignRun::Verdict::undecided:
      return "undecided";
    case CampaignRun::Verdict::impossible:
      return "impossible";
  }
  CHECK(false && "every verdict has a name");
  return {};
}

void expect_faults(const automata::Document& document, const automata::Scenario& scenario, std::size_t faults) {
  if (scenario.rules_only) {
    throw base::InputError("scenario '" + scenario.name +
                           "': its plant follows the rules only, and has no faults to inject");
  }
  const automata::Plant& plant = document.plants[scenario.plant];
  const std::size_t fallible = fallible_components(plant);
  if (faults > fallible) {
    throw base::InputError("--faults: only " + std::to_string(fallible) + " components of plant '" + plant.name +
                           "' have faults");
  }
}

std::uint64_t cycles_without_faults(const automata::Document& document, const automata::Scenario& scenario,
                                    const ScenarioOptions& options) {
  return std::max<std::uint64_t>(run_scenario(document, scenario, options, {}).cycles, 1);
}

std::optional<CampaignRun> fly_run(const automata::Document& document, const automata::Scenario& scenario,
                                   const CampaignPlan& plan, std::uint64_t run, ScenarioOptions options,
                                   const std::vector<CycleObserver*>& observers, ScenarioResult* whole) {
  const automata::Plant& plant = document.plants[scenario.plant];
  CampaignRun result;
  result.run = run;
  result.seed = seed_of_run(plan, run);
  automata::Scenario flown = scenario;
  const auto faults = injections(plan, plant, scenario.cycle, run);
  for (const automata::ForcedMode& fault : faults) {
    const bool at_once = plan.unmodelled && !plant[fault.component].software;
    (at_once ? flown.forced : options.awaited).push_back(fault);
  }
  options.seed = result.seed;
  CampaignWatch watch(plant, faults);
  std::vector<CycleObserver*> all = observers;
  all.push_back(&watch);
  try {
    const ScenarioResult flight = run_scenario(document, flown, options, all);
    if (whole != nullptr) *whole = flight;
    if (flight.interrupted) return std::nullopt;
    result.verdict = verdict_of(flight.verdict());
    result.ended = flight.ended;
    result.time = flight.time;
    result.cycles = flight.cycles;
    result.right = watch.right();
    result.by_chance = watch.by_chance();
    result.injected = watch.injected();
  } catch (const base::InputError&) {
    // What is wrong with the scenario itself was found by the flight without injections.
    result.verdict = CampaignRun::Verdict::impossible;
    for (const automata::ForcedMode& fault : faults) result.injected.push_back({fault, {}, {}, {}});
  }
  return result;
}

}  // namespace rmpl::runtime
