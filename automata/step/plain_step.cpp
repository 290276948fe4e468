// The rules over a plain store.
// SPDX-License-Identifier: MIT
#include "automata/step/plain_step.hpp"

namespace rmpl::automata {

std::vector<Enabled> PlainStep::enabled(const Modes& modes, const ControlAction& action) {
  const std::vector<std::vector<bool>> implied = store_.implied_guards(modes, action);
  std::vector<Enabled> all;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    all.push_back(enabled_in(plant()[ComponentId(c)], modes[c],
                             [&](TransitionId transition) { return implied[c][transition.index()]; }));
  }
  return all;
}

std::vector<bool> PlainStep::restarted(const Modes& modes, const ControlAction& action) {
  std::vector<bool> result(modes.size(), false);
  if (!has_restarts_) return result;
  const std::vector<Enabled> all = enabled(modes, action);
  for (std::size_t c = 0; c < modes.size(); ++c) result[c] = restarts(plant().components[c], all[c]);
  return result;
}

SystemState PlainStep::advance(const SystemState& state, const ControlAction& action, const Modes& next, Ticks now) {
  return automata::advance(state, restarted(state.modes, action), next, now);
}

std::vector<std::vector<Move>> PlainStep::moves(const SystemState& state, const ControlAction& action, Ticks before,
                                                Ticks now) {
  const std::vector<Enabled> allowed = enabled(state.modes, action);
  std::vector<std::vector<Move>> all;
  for (std::size_t c = 0; c < allowed.size(); ++c) {
    all.push_back(
        moves_of(plant()[ComponentId(c)], state.modes[c], allowed[c], now - state.clock_starts[c], now - before));
  }
  return all;
}

}  // namespace rmpl::automata
