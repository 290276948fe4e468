// MR: from goals and the estimate to a command.
// SPDX-License-Identifier: MIT
#include "runtime/executive/cycle/reconfiguration_dispatcher.hpp"

#include <algorithm>
#include <utility>

namespace rmpl::runtime {

ReconfigurationDispatcher::ReconfigurationDispatcher(const automata::Plant& plant, Reconfigurer& reconfigurer,
                                                     const Clock& clock, MessageQueue<ReconfigurationMessage>& queue,
                                                     ControlAdapter& control)
    : reconfigurer_(reconfigurer), clock_(clock), queue_(queue), control_(control) {
  pursued_.answer.action = automata::idle_action(plant);
  issued_ = pursued_.answer.action;
}

void ReconfigurationDispatcher::dispatch() {
  while (const auto message = queue_.pop()) {
    std::visit([this](const auto& m) { handle(m); }, *message);
  }
}

// 4. Goals are dequeued.
void ReconfigurationDispatcher::handle(const GoalAsserted& message) { goals_.push_back(*message.goals); }

void ReconfigurationDispatcher::handle(const ReconfigurationRequested&) {
  // 5. The request invokes MR with the configuration goal, 6. which returns the next command of a sequence.
  checked_ = 0;
  StrategyPosition position = tracked_.empty() ? StrategyPosition() : position_after(pursued_.answer, tracked_.front());
  if (tracked_ != asked_states_ || goals_ != asked_goals_ || position != position_) {
    pursued_ = pursue(reconfigurer_, tracked_, goals_, position);
    position_ = std::move(position);
    asked_states_ = tracked_;
    checked_ = pursued_.answer.checked;
    asked_goals_ = goals_;
  }
  goals_.clear();
  issued_ = pursued_.answer.action;
  if (script_ != nullptr) script_->command(issued_, clock_.now());
  if (issued_ != pursued_.answer.action) {
    // What would follow the answer says nothing of what follows another command.
    pursued_.answer.edges = nullptr;
    asked_states_.clear();
  }
  // 7. It goes to the control adapter.
  control_.issue(issued_, clock_.now());
}

void ReconfigurationDispatcher::handle(const StateEstimated& message) {
  tracked_.resize(1);
  tracked_.front().assign(message.modes.begin(), message.modes.end());
  if (!reconfigurer_.looks_at_all()) return;
  for (const BeliefEntry& entry : message.estimator->belief()) {
    if (std::find(tracked_.begin(), tracked_.end(), entry.state.modes) == tracked_.end()) {
      tracked_.push_back(entry.state.modes);
    }
  }
}

}  // namespace rmpl::runtime
