// The ME side of the RTAPI: the dispatcher that empties its queue (thesis 7.1.1).
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/state.hpp"
#include "runtime/executive/cycle/clock.hpp"
#include "runtime/executive/cycle/message.hpp"
#include "runtime/executive/cycle/message_queue.hpp"
#include "runtime/reasoning/estimate/estimator.hpp"

namespace rmpl::runtime {

/// Collects commands and observations, and estimates when asked to.
class EstimationDispatcher {
 public:
  /// Messages come in `queue`, states go to `reconfiguration`. Keeps references to all but `plant`.
  EstimationDispatcher(const automata::Plant& plant, Estimator& estimator, const Clock& clock,
                       MessageQueue<EstimationMessage>& queue, MessageQueue<ReconfigurationMessage>& reconfiguration);

  /// Steps 11 to 15: dequeues all there is. A request makes an estimate as of the clock's time, sends it to MR, and
  /// leaves it in `estimate()` for the sequencer.
  void dispatch();
  [[nodiscard]] const Estimate& estimate() const { return estimator_.estimate(); }
  /// The time for which the last estimate was made.
  [[nodiscard]] automata::Ticks time() const { return time_; }

 private:
  void handle(const CommandIssued& message);
  void handle(const ObservationArrived& message);
  void handle(const EstimateRequested& message);

  Estimator& estimator_;
  const Clock& clock_;
  MessageQueue<EstimationMessage>& queue_;
  MessageQueue<ReconfigurationMessage>& reconfiguration_;
  automata::ControlAction action_;     ///< of the last command message
  automata::Observation observation_;  ///< since the last request; a later reading of a variable replaces an earlier
  automata::Ticks time_;
};

}  // namespace rmpl::runtime
