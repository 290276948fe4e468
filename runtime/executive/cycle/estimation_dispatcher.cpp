// ME: from commands and observations to the most likely state.
// SPDX-License-Identifier: MIT
#include "runtime/executive/cycle/estimation_dispatcher.hpp"

#include <algorithm>

namespace rmpl::runtime {

EstimationDispatcher::EstimationDispatcher(const automata::Plant& plant, Estimator& estimator, const Clock& clock,
                                           MessageQueue<EstimationMessage>& queue,
                                           MessageQueue<ReconfigurationMessage>& reconfiguration)
    : estimator_(estimator),
      clock_(clock),
      queue_(queue),
      reconfiguration_(reconfiguration),
      action_(automata::idle_action(plant)) {
  reconfiguration_.push(StateEstimated{estimator_.estimate().modes, &estimator_});
}

// 11. As the messages arrive they are dequeued and asserted.
void EstimationDispatcher::dispatch() {
  while (const auto message = queue_.pop()) {
    std::visit([this](const auto& m) { handle(m); }, *message);
  }
}

void EstimationDispatcher::handle(const CommandIssued& message) {
  action_.assign(message.action.begin(), message.action.end());
}

void EstimationDispatcher::handle(const ObservationArrived& message) {
  for (const automata::Assignment& reading : message.observation) {
    const auto at = std::lower_bound(observation_.begin(), observation_.end(), reading.variable,
                                     [](const auto& known, automata::VariableId id) { return known.variable < id; });
    if (at != observation_.end() && at->variable == reading.variable) {
      at->value = reading.value;
    } else {
      observation_.insert(at, reading);
    }
  }
}

void EstimationDispatcher::handle(const EstimateRequested&) {
  // 12. The request invokes ME, 13. which queries the clock, and 14. returns the most likely state;
  time_ = clock_.now();
  const Estimate& estimate = estimator_.update(action_, observation_, time_);
  observation_.clear();
  // 15. it goes to MR, and to the sequencer, which reads `estimate()`.
  reconfiguration_.push(StateEstimated{estimate.modes, &estimator_});
}

}  // namespace rmpl::runtime
