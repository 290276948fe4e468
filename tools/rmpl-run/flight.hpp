// One flight of `rmpl-run scenario`: what looks on, and what is said of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/executive/scenario/run.hpp"
#include "runtime/report/coverage.hpp"
#include "runtime/report/flight.hpp"
#include "tools/rmpl-run/flight_options.hpp"
#include "tools/rmpl-run/in_turn.hpp"

namespace rmpl::tools {

/// A scenario that is to be flown. All but the file stays where it is while flights go on.
struct Task {
  std::string file;  ///< as it was named
  const automata::Document* document;
  const automata::Scenario* scenario;
  std::shared_ptr<const runtime::NominalGraph> graph;  ///< of its plant
};

/// A scenario that was flown, and how long that took.
struct Flown {
  const automata::Scenario* scenario = nullptr;
  runtime::ScenarioResult result;
  double seconds = 0;
  std::optional<runtime::Flight> data = std::nullopt;  ///< where the options ask for it
  std::vector<runtime::CoverageItem> coverage = {};    ///< likewise
};

/// Flies the task at `position` of `count`, and tells its story as it happens. Throws base::InputError.
Flown fly(const Task& task, const FlightOptions& options, const Common& common, InTurn& voices, std::size_t position,
          std::size_t count);

}  // namespace rmpl::tools
