// The adapters between the deductive controller and the plant (thesis 7.1.1, Fig. 7-1).
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/state.hpp"
#include "runtime/executive/cycle/clock.hpp"
#include "runtime/executive/cycle/message.hpp"
#include "runtime/executive/cycle/message_queue.hpp"
#include "runtime/executive/plant/plant_interface.hpp"

namespace rmpl::runtime {

/// Turns assignments to control variables into commands to the plant, and tells ME of them.
class ControlAdapter {
 public:
  ControlAdapter(PlantInterface& plant, MessageQueue<EstimationMessage>& estimation)
      : plant_(plant), estimation_(estimation) {}

  /// Steps 7 and 8. `action` stays as it is until ME has dispatched.
  void issue(const automata::ControlAction& action, automata::Ticks now) {
    plant_.issue(action, now);
    estimation_.push(CommandIssued{action});
  }
  /// Step 10, after the delay that lets the observations arrive.
  void request_estimate() { estimation_.push(EstimateRequested{}); }

 private:
  PlantInterface& plant_;
  MessageQueue<EstimationMessage>& estimation_;
};

/// Turns measurements into assignments to observable variables, and tells ME of them.
class MonitorAdapter {
 public:
  MonitorAdapter(PlantInterface& plant, MessageQueue<EstimationMessage>& estimation)
      : plant_(plant), estimation_(estimation) {}

  /// Step 9. The readings, which stay as they are until the next call.
  const automata::Observation& sample(automata::Ticks now) {
    const automata::Observation& readings = plant_.sense(now);
    estimation_.push(ObservationArrived{readings});
    return readings;
  }

 private:
  PlantInterface& plant_;
  MessageQueue<EstimationMessage>& estimation_;
};

}  // namespace rmpl::runtime
