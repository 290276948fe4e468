// What a strategy may bring components to, each looked at by itself: too much at most, never too little.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/state.hpp"
#include "runtime/reasoning/game/game_goal.hpp"
#include "runtime/reasoning/nominal/closures.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"

namespace rmpl::runtime {

/// What permitted strategies and nature may come to from some modes.
struct WithinReach {
  Reached modes;
  /// By component, by place among its nominal transitions: steps that no permitted strategy takes. They cannot be
  /// undone, the goal does not license them, and resting cannot bring them from anything within reach.
  std::vector<std::vector<bool>> barred;
};

/// Where the model excludes no commands, so that the executive rests with all controls idle. Components that are not
/// `free` keep their modes.
WithinReach within_reach(const NominalGraph& graph, const GameGoal& goal, const automata::Modes& modes,
                         const std::vector<automata::ComponentId>& free);

}  // namespace rmpl::runtime
