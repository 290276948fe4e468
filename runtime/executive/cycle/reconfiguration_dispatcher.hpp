// The MR side of the RTAPI: a queue, and the dispatcher that empties it (thesis 7.1.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/state.hpp"
#include "runtime/executive/cycle/adapters.hpp"
#include "runtime/executive/cycle/message.hpp"
#include "runtime/executive/cycle/message_queue.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// Conjoins goals, and has a command issued when asked to.
class ReconfigurationDispatcher {
 public:
  ReconfigurationDispatcher(const automata::Plant& plant, Reconfigurer& reconfigurer, const Clock& clock);

  MessageQueue<ReconfigurationMessage>& queue() { return queue_; }
  /// Where commands go; ME's queue has to be there first, so it is told after construction.
  void connect(ControlAdapter& control) { control_ = &control; }
  /// Steps 4 to 7: dequeues all there is. A request issues one command, idle unless there is something to do.
  void dispatch();
  /// What MR answered to the last request.
  [[nodiscard]] const Reconfiguration& answer() const { return answer_; }
  /// Candidates that MR checked for it; 0 where nothing had changed and MR was not asked anew.
  [[nodiscard]] std::size_t checked() const { return checked_; }
  /// The command that was issued then.
  [[nodiscard]] const automata::ControlAction& command() const;

 private:
  void handle(const GoalAsserted& message);
  void handle(const ReconfigurationRequested& message);
  void handle(const StateEstimated& message);

  Reconfigurer& reconfigurer_;
  const Clock& clock_;
  ControlAdapter* control_ = nullptr;
  MessageQueue<ReconfigurationMessage> queue_;
  std::vector<automata::Modes> tracked_;  ///< the most likely first; it alone where MR does not look at the others
  std::vector<automata::Assignment> goals_;
  const automata::ControlAction idle_;
  // Most cycles ask what the cycle before asked, and an answer depends on states and goal alone: no formula is made
  // then.
  std::vector<automata::Modes> asked_states_;
  std::vector<automata::Assignment> asked_goals_;
  Reconfiguration answer_;
  std::size_t checked_ = 0;
};

}  // namespace rmpl::runtime
