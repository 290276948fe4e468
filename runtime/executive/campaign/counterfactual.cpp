// The twin flight without the injected fault.
// SPDX-License-Identifier: MIT
#include "runtime/executive/campaign/counterfactual.hpp"

#include <algorithm>

#include "automata/fault_step.hpp"

namespace rmpl::runtime {
namespace {

automata::ModeId most_likely(const std::vector<automata::Move>& moves) {
  return std::max_element(moves.begin(), moves.end(),
                          [](const auto& a, const auto& b) { return a.probability < b.probability; })
      ->mode;
}

/// What the scenario forces is no move, and happens in the twin as well.
bool is_forced(const FlownStep& flown, std::size_t component) {
  return std::any_of(flown.events.begin(), flown.events.end(), [&](const Event& event) {
    return event.kind == Event::Kind::forced && event.component == automata::ComponentId(component);
  });
}

}  // namespace

bool Counterfactual::contradicted_by(const FlownStep& flown) {
  if (!step_.permits(state_.modes, flown.command)) return true;
  const auto& moves = step_.moves(state_, flown.command, flown.from, flown.to);
  automata::Modes next = flown.after;
  for (std::size_t c = 0; c < moves.size(); ++c) {
    const bool injected = !parted_ && c == component_.index();
    const bool together = state_.modes[c] == flown.before[c] && !injected;
    const bool can = std::any_of(moves[c].begin(), moves[c].end(),
                                 [&](const automata::Move& move) { return move.mode == flown.after[c]; });
    // A fault that befell the component by chance befalls the twin, if it can: it is no consequence of the one
    // injected.
    const bool mischance =
        !injected && can && automata::is_fault_step(step_.plant().components[c], flown.before[c], flown.after[c]);
    const bool follows = mischance || (together && (can || is_forced(flown, c)));
    if (!follows) next[c] = most_likely(moves[c]);
  }
  parted_ = true;
  if (!step_.possible(next)) return true;
  state_ = step_.advance(state_, flown.command, next, flown.to);
  return !step_.explains(next, flown.readings);
}

}  // namespace rmpl::runtime
