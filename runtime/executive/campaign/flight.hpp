// One run of a campaign, from its number to its result.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "automata/scenario.hpp"
#include "runtime/executive/campaign/injection.hpp"
#include "runtime/executive/campaign/watch.hpp"
#include "runtime/executive/scenario/run.hpp"

namespace rmpl::runtime {

/// What came of one run. Nothing in it depends on the machine.
struct CampaignRun {
  enum class Verdict {
    met,
    failed,
    undecided,
    impossible  ///< the model has no consistent state with the fault in it; the numbers are all 0
  };
  std::uint64_t run = 0;
  std::uint64_t seed = 0;
  Verdict verdict = Verdict::met;
  std::optional<automata::Ticks> ended;  ///< when the program did
  automata::Ticks time;                  ///< at the end of the last cycle
  std::uint64_t cycles = 0;
  std::uint64_t right = 0;      ///< of them, those whose estimate was the truth
  std::uint64_t by_chance = 0;  ///< faults that the model drew
  std::vector<Injected> injected;
};

/// `met`, `failed`, `undecided`, `impossible`.
std::string_view name_of(CampaignRun::Verdict verdict);

/// Whether so many faults can be injected into the flights of a scenario. Throws base::InputError where not: its plant
/// is a model program, follows rules only, or has fewer components with faults.
void expect_faults(const automata::Document& document, const automata::Scenario& scenario, std::size_t faults);

/// How long the flight is without injections, at least 1, which also shows what is wrong with the scenario itself.
std::uint64_t cycles_without_faults(const automata::Document& document, const automata::Scenario& scenario,
                                    const ScenarioOptions& options);

/// Flies a run; nothing where it was interrupted. The scenario's plant is drawn, and its own faults happen as well.
/// `observers` look on, and `whole`, where it is not null, gets how the flight ended.
std::optional<CampaignRun> fly_run(const automata::Document& document, const automata::Scenario& scenario,
                                   const CampaignPlan& plan, std::uint64_t run, ScenarioOptions options,
                                   const std::vector<CycleObserver*>& observers = {}, ScenarioResult* whole = nullptr);

}  // namespace rmpl::runtime
