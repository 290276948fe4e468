// From the deductive controller to the plant (thesis 7.1.1, Fig. 7-1).
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/state.hpp"
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

}  // namespace rmpl::runtime
