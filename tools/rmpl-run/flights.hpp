// Many flights, several at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tools/rmpl-run/flight.hpp"

namespace rmpl::tools {

/// Flies all tasks on `options.jobs` threads; what is said and what comes back is the same for any number. Once
/// interrupted no flight is begun: those that come back are the first ones, in order, up to the first that was cut off.
/// Throws what the first flight that fails throws.
std::vector<Flown> fly_all(const std::vector<Task>& tasks, const FlightOptions& options, const Common& common);

}  // namespace rmpl::tools
