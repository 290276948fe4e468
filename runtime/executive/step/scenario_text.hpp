// A scenario as the text of a `.scn` file.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/plant.hpp"
#include "automata/scenario.hpp"

namespace rmpl::runtime {

/// What a scenario calls its files: paths, and definitions where there is more than one to start with.
struct ScenarioPlaces {
  std::string program, program_main;
  std::string plant, plant_main;
};

/// The text compiles to the scenario again, but for places. `plant`: what it is about.
std::string scenario_text(const automata::Scenario& scenario, const automata::Plant& plant,
                          const ScenarioPlaces& places);

}  // namespace rmpl::runtime
