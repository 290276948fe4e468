// What is chosen by its words, as they stand in a scenario.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "runtime/executive/step/flight_steps.hpp"
#include "tools/shared/options.hpp"

namespace rmpl::tools {

// Each is about the cycle that begins. Throw base::InputError where it cannot be, Rejected where names or values are
// wrong; then nothing is chosen.

/// `engine = failed, valve = stuck`: modes at the end of the cycle.
void choose_fault(runtime::FlightSteps& flight, const std::string& text, const Common& common);
/// `engine.cmd = off`: of the command.
void choose_command(runtime::FlightSteps& flight, const std::string& text, const Common& common);
/// `engine.temp = low for 3 s`: readings from the end of the cycle on; for ever where it does not say.
void choose_reading(runtime::FlightSteps& flight, const std::string& text, const Common& common);

}  // namespace rmpl::tools
