// A strategy as an automaton: what the executive does in each state that it may come to (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "automata/state.hpp"
#include "runtime/reasoning/game/cost.hpp"
#include "runtime/reasoning/game/strategist.hpp"

namespace rmpl::runtime {

struct Strategy {
  struct Edge {
    automata::Modes modes;  ///< that are seen next
    std::uint32_t node;
  };
  struct KnownAge {
    automata::ComponentId component;
    automata::Ticks least, most;
  };
  struct Node {
    automata::Modes modes;
    std::vector<KnownAge> ages;  ///< of components whose mode has timed exits, where ages are known
    GameDecision::Purpose purpose = GameDecision::Purpose::none;
    automata::ControlAction action;
    bool goal = false;       ///< the goal holds
    std::vector<Edge> next;  ///< in order of modes; an edge to its own modes is a cycle in which nothing changed
  };
  Rank rank = Rank::none;
  bool lasts = false;
  bool best = true;          ///< by proof: all actions were looked at, and no group waits for its turn
  std::optional<Cost> cost;  ///< where one group has a strategy for all of the goal
  std::vector<Node> nodes;   ///< node 0 is the start
};

/// The strategy from possible modes on; nothing where the game, or the strategy, is too large. Components that no part
/// of the game has are left in their modes.
std::optional<Strategy> strategy_from(Strategist& strategist, const automata::Modes& modes);

}  // namespace rmpl::runtime
