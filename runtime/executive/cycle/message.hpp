// What travels through the two queues of the RTAPI (thesis 7.1.1, Fig. 7-1).
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <variant>

#include "automata/state.hpp"
#include "automata/step/program_rules.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

// Messages refer to buffers of their senders; these stay as they are until the message has been dispatched.

/// Control adapter to ME: this command has been issued (step 8).
struct CommandIssued {
  std::span<const automata::ValueId> action;
};
/// Monitor adapter to ME: this was observed (step 9).
struct ObservationArrived {
  std::span<const automata::Assignment> observation;
};
/// Control adapter to ME: estimate now (step 10).
struct EstimateRequested {};

using EstimationMessage = std::variant<CommandIssued, ObservationArrived, EstimateRequested>;

/// Sequencer to MR: goals that are asked for together (step 2).
struct GoalAsserted {
  const automata::Goals* goals;
};
/// Sequencer to MR: compute a command for the goals received to date (step 3).
struct ReconfigurationRequested {};
/// ME dispatcher to MR: the new state (step 15).
struct StateEstimated {
  std::span<const automata::ModeId> modes;
  const Estimator* estimator;  ///< whose belief has all states that are tracked; it costs something to list them
};

using ReconfigurationMessage = std::variant<GoalAsserted, ReconfigurationRequested, StateEstimated>;

}  // namespace rmpl::runtime
