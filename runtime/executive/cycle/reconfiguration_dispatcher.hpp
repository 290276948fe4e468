// The MR side of the RTAPI: the dispatcher that empties its queue (thesis 7.1.1).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/state.hpp"
#include "runtime/executive/cycle/clock.hpp"
#include "runtime/executive/cycle/command_script.hpp"
#include "runtime/executive/cycle/control_adapter.hpp"
#include "runtime/executive/cycle/message.hpp"
#include "runtime/executive/cycle/message_queue.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"
#include "runtime/reasoning/reconfigure/several_goals.hpp"

namespace rmpl::runtime {

/// Collects goals, and has a command issued for them when asked to.
class ReconfigurationDispatcher {
 public:
  /// Messages come in `queue`, commands go to `control`. Keeps references to all.
  ReconfigurationDispatcher(const automata::Plant& plant, Reconfigurer& reconfigurer, const Clock& clock,
                            MessageQueue<ReconfigurationMessage>& queue, ControlAdapter& control);

  /// From now on what a scenario commands takes the place of MR's command. Keeps a reference.
  void obey(const CommandScript& script) { script_ = &script; }
  /// Steps 4 to 7: dequeues all there is. A request issues one command.
  void dispatch();
  /// What MR answered to the last request, and about which goals.
  [[nodiscard]] const Pursued& pursued() const { return pursued_; }
  /// What was issued for it: MR's command, or what the scenario commands.
  [[nodiscard]] const automata::ControlAction& issued() const { return issued_; }
  /// Candidates that MR checked for it; 0 where nothing had changed and MR was not asked anew.
  [[nodiscard]] std::size_t checked() const { return checked_; }

 private:
  void handle(const GoalAsserted& message);
  void handle(const ReconfigurationRequested& message);
  void handle(const StateEstimated& message);

  Reconfigurer& reconfigurer_;
  const Clock& clock_;
  MessageQueue<ReconfigurationMessage>& queue_;
  ControlAdapter& control_;
  std::vector<automata::Modes> tracked_;  ///< the most likely first; it alone where MR does not look at the others
  std::vector<automata::Goals> goals_;
  // Most cycles ask what the cycle before asked, and an answer depends on states, goal and position alone: no formula
  // is made then.
  std::vector<automata::Modes> asked_states_;
  std::vector<automata::Goals> asked_goals_;
  StrategyPosition position_;  ///< that was asked from
  Pursued pursued_;
  const CommandScript* script_ = nullptr;
  automata::ControlAction issued_;
  std::size_t checked_ = 0;
};

}  // namespace rmpl::runtime
