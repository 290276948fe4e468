// What came of many scenarios, on one page.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "base/painter.hpp"
#include "tools/rmpl-run/flight.hpp"

namespace rmpl::tools {

/// A line for each flight, below the name of its file: the verdict, how long the flight was, the scenario. Below it,
/// where `reasons`, what it did not meet, when and why. Then how many came out how; `flights` may be fewer than the
/// tasks, where they were cut off.
std::string to_table(const std::vector<Task>& tasks, const std::vector<Flown>& flights, bool reasons,
                     base::Painter painter);

}  // namespace rmpl::tools
