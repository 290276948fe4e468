// Timed traces: the evidence that a witness is.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/state.hpp"
#include "verifier/plant/plant_system.hpp"
#include "verifier/search/search.hpp"

namespace rmpl::verifier {

/// The state that a step leads to, at the time of the step; the first event is the start, at time 0. Between two events
/// all controls are idle and nothing changes. Where the modes are those of the event before, nothing changed: a command
/// kept it so, or the last event is the time at which the target counts.
struct Event {
  automata::Ticks time;
  automata::Modes modes;
  automata::ControlAction action;  ///< in force for the step
  bool operator==(const Event&) const = default;
};

using Trace = std::vector<Event>;

/// The trace with the earliest times of a path of the system to an accepted state.
Trace earliest_trace(const std::vector<PathState>& path, PlantSystem& system);

/// How many components went into a fault mode along the trace.
std::size_t faults_in(const automata::Plant& plant, const Trace& trace);

}  // namespace rmpl::verifier
