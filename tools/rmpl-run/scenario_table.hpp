// What came of many scenarios, on one page.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "base/painter.hpp"
#include "tools/rmpl-run/scenario_outcomes.hpp"

namespace rmpl::tools {

/// Which lines a table has: those of all scenarios; those with what was not met, when and why, below; or the latter
/// alone, without those of scenarios that met everything.
enum class TableDetail { verdicts, reasons, failures };

/// A line for each scenario, below the name of its file: the verdict, how long the flight was, the scenario; a line for
/// a file that is wrong or was not read. Then how many came out how.
std::string to_table(const std::vector<ScenarioOutcome>& outcomes, TableDetail detail, base::Painter painter);

}  // namespace rmpl::tools
