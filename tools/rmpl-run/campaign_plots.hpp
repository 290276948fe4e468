// Pictures of a campaign, as SVG within its page.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "runtime/executive/campaign/flight.hpp"

namespace rmpl::tools {

/// A number of runs with what came of them.
struct Outcomes {
  std::uint64_t met = 0, failed = 0, undecided = 0, impossible = 0;
};

/// A bar in as many parts as there are outcomes, each with its words.
std::string outcome_plot(const Outcomes& outcomes);

/// How often a fault was named so long after its symptom: bars of equal width, of at most as many times as are there.
/// Empty where there are no latencies.
std::string latency_plot(std::vector<automata::Ticks> latencies);

/// When the faults of failing runs happened: a row for each fault, a mark for each time. Empty where no fault did.
std::string failure_plot(const std::vector<runtime::CampaignRun>& failed, const automata::Plant& plant);

/// Text as HTML and SVG take it.
std::string escaped(const std::string& text);

}  // namespace rmpl::tools
