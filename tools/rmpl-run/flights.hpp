// Many flights, several at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "tools/rmpl-run/flight.hpp"

namespace rmpl::tools {

/// Flies all tasks on `options.jobs` threads; what is said and what comes back, one by one, is the same for any number.
/// Once interrupted no flight is begun: nothing comes back of those that were not. Throws what the first flight that
/// fails throws.
std::vector<std::optional<Flown>> fly_all(const std::vector<Task>& tasks, const FlightOptions& options,
                                          const Common& common);

}  // namespace rmpl::tools
