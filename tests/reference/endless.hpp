// Runs without end, and runs that cannot go on, in a graph of states: the twin of verifier/search/lasso.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "automata/logic/ids.hpp"

namespace rmpl::reference {

/// Per component the modes that its exits lead to.
struct Exits {
  std::vector<std::set<automata::ModeId>> enabled;  ///< those that are enabled however late it is
  std::vector<std::set<automata::ModeId>> open;     ///< of those, the ones that some joint step takes
};

struct RunEdge {
  std::size_t from, to;
  bool time;                ///< it takes time
  bool nominal;             ///< no fault happens on it
  std::vector<bool> moves;  ///< per component: it leaves its mode
  const Exits* exits;       ///< where it comes from; none where what is enabled on it does not count
  int lasts = 2;            ///< 0: it exists at that instant only; 1: it does as the first step of an instant
};

/// Whether some run goes on for ever: it takes time again and again, and no component stays in a mode all the while
/// though exits are enabled at each of its steps of which one is open at some.
bool runs_for_ever(const std::vector<RunEdge>& edges, std::size_t components);

/// Whether from one of the states on, edges without a fault never take time again: it leads nowhere, or round and round
/// at one instant. Nothing is said of states that are not `judged`: there they may. What exists at one instant only
/// leads nowhere.
bool comes_to_a_stop(const std::vector<RunEdge>& edges, const std::vector<bool>& judged);

}  // namespace rmpl::reference
