// Which faults a run of a campaign injects: drawn, or enumerated. A pure function of campaign and run.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/scenario.hpp"

namespace rmpl::runtime {

/// What a campaign flies, aside from how many runs.
struct CampaignPlan {
  std::uint64_t seed = 1;
  std::size_t faults = 0;              ///< drawn per run; at most as many as components have faults
  std::vector<automata::Ticks> times;  ///< of an enumeration; empty where faults are drawn
  std::uint64_t cycles = 1;            ///< of the flight without injections, among which a draw chooses
  bool unmodelled = false;             ///< a fault happens at its time even where the model has no transition to it
};

/// A fault mode of a component.
struct Fault {
  automata::ComponentId component;
  automata::ModeId mode;
};

/// All of them, in order of declaration.
std::vector<Fault> faults_of(const automata::Plant& plant);
/// How many components have one.
std::size_t fallible_components(const automata::Plant& plant);

/// The seed of all draws of a run, from 0 to 2^63 - 1. Runs count from 0.
std::uint64_t seed_of_run(const CampaignPlan& plan, std::uint64_t run);

/// The faults of a run, by time. Drawn: `faults` times a fault among those of components that have none yet, each as
/// likely as the others, and for each the end of a cycle, each as likely. Enumerated: run r has fault r modulo their
/// number, at time (r / that number) modulo the number of times.
std::vector<automata::ForcedMode> injections(const CampaignPlan& plan, const automata::Plant& plant,
                                             automata::Ticks cycle, std::uint64_t run);

}  // namespace rmpl::runtime
