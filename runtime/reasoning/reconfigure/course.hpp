// How a plant goes on where something is done for reward (semantics 5, *No thrashing*).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/parts.hpp"

namespace rmpl::runtime {

/// From state to state, as the nominal model has it. Keeps a reference to the step.
class Course {
 public:
  Course(automata::PlantStep& step, const NominalGraph& graph, const Parts& parts);

  /// Where a command leads; where it leads nowhere, what comes by itself in parts where something may be done for
  /// reward: at once, or else in time, all of that together or one of it.
  std::vector<automata::Modes> next(const automata::Modes& modes, const std::optional<automata::Modes>& expected);
  /// What comes by itself there before what is waited for, which `expected` has.
  std::vector<automata::Modes> meanwhile(const automata::Modes& modes, const automata::Modes& expected);

 private:
  std::vector<automata::Modes> by_itself(const automata::Modes& modes, const automata::Modes& awaited);

  automata::PlantStep& step_;
  automata::ControlAction idle_;
  std::vector<automata::ComponentId> paid_;  ///< of parts with a control, where modes are worth more than others
};

}  // namespace rmpl::runtime
