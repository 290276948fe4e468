// What came of the scenarios that were asked for: flown, not flown, or in a file that gave none.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/rmpl-run/flight.hpp"
#include "tools/rmpl-run/scenario_files.hpp"
#include "tools/shared/exit_status.hpp"

namespace rmpl::tools {

/// One line of an answer: a scenario; or a whole file, where it is wrong or was not read.
struct ScenarioOutcome {
  const ScenarioFile* file;
  const automata::Scenario* scenario = nullptr;  ///< nothing: the whole file
  const Flown* flown = nullptr;                  ///< nothing: an interruption came before

  [[nodiscard]] bool wrong() const { return !file->wrong.empty(); }
};

/// In the order of the files. `flights` are those of the tasks, one by one; all outlive the result.
std::vector<ScenarioOutcome> outcomes_of(const std::vector<ScenarioFile>& files, const std::vector<Task>& tasks,
                                         const std::vector<std::optional<Flown>>& flights);

/// A file that is wrong outweighs a failure, that what is undecided or was not flown, and that success.
ExitStatus status_of(const std::vector<ScenarioOutcome>& outcomes);

/// grammar/schema/scenario_result.schema.json
std::string to_json(const std::vector<ScenarioOutcome>& outcomes);

/// A suite for each file, with a case for each expectation of each scenario, in their order; a scenario that expects
/// nothing is one case. How long a flight took stands with its first case. What is undecided is an error, as is a file
/// that is wrong; what was not flown is skipped.
std::string to_junit(const std::vector<ScenarioOutcome>& outcomes);

}  // namespace rmpl::tools
