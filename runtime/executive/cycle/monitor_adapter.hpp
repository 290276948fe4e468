// From the plant to the deductive controller (thesis 7.1.1, Fig. 7-1).
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/state.hpp"
#include "runtime/executive/cycle/message.hpp"
#include "runtime/executive/cycle/message_queue.hpp"
#include "runtime/executive/plant/plant_interface.hpp"

namespace rmpl::runtime {

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
