// The runs of a campaign as rows: CSV and JSON.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/plant.hpp"
#include "runtime/executive/campaign/flight.hpp"
#include "runtime/executive/trace/json_line.hpp"

namespace rmpl::runtime {

/// The head of the CSV, and the line of a run. Times are seconds; several faults stand behind each other, with `;`.
std::string csv_head();
std::string csv_line(const CampaignRun& run, const automata::Plant& plant);

/// One object: the columns of the CSV by name, and below `faults` an object each. Times are seconds; null is never.
void write(JsonLine& json, const CampaignRun& run, const automata::Plant& plant);

}  // namespace rmpl::runtime
