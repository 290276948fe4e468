// Commands that a scenario gives at given times: an operator beside the executive.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/plant.hpp"
#include "automata/scenario.hpp"
#include "automata/state.hpp"

namespace rmpl::runtime {

/// Of several commands of one control the one that began last counts, and of those that began together the one written
/// last.
class CommandScript {
 public:
  /// Keeps a reference to `plant`.
  CommandScript(const automata::Plant& plant, const automata::Scenario& scenario);

  /// Puts what the scenario commands in the cycle that begins at `now` into the action.
  void command(automata::ControlAction& action, automata::Ticks now) const;

 private:
  const automata::Plant& plant_;
  std::vector<automata::GivenCommand> commands_;  ///< in order of beginning
};

}  // namespace rmpl::runtime
