// The answer to a line of a plant's log, as JSON.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"
#include "runtime/reasoning/estimate/plant_window.hpp"

namespace rmpl::tools {

/// What an update cost, and what it may have missed.
struct UpdateCost {
  std::size_t checked = 0;
  double dropped = 0;  ///< of what followed from the belief before
  double missing = 0;
};

/// What most likely happened: trajectories, best first, the times of their states, and where the best of them differs
/// from what it was after the line before.
struct PlantHistory {
  std::vector<automata::Ticks> times;
  std::vector<runtime::PlantTrajectory> trajectories;
  std::size_t first = 0;  ///< the update after which they set out
  struct Revision {
    automata::Ticks time;
    automata::Modes before, now;
  };
  std::vector<Revision> revised;
  bool cut = false;  ///< the search for them ended early
};

/// What is told of a line.
struct PlantAnswer {
  const runtime::LogLine& line;
  const runtime::Estimate& estimate;
  const runtime::Belief& belief;
  const UpdateCost* cost;             ///< where it is told
  const PlantHistory* history;        ///< where there is a window
  const runtime::ClockTable* clocks;  ///< those that are told; all where it is empty
  bool ranks;                         ///< in place of probabilities
};

/// One line of JSON, without its end. Keeps nothing; `json` is the buffer.
void write(runtime::JsonLine& json, const PlantAnswer& answer, const automata::Plant& plant);

}  // namespace rmpl::tools
