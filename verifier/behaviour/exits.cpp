// The ways out of modes that chance takes at last.
// SPDX-License-Identifier: MIT
#include "verifier/behaviour/exits.hpp"

#include <algorithm>

namespace rmpl::verifier {

using automata::ComponentId;
using automata::ModeId;
using automata::Modes;

namespace {

void include(std::vector<ModeId>& modes, ModeId mode) {
  const auto at = std::lower_bound(modes.begin(), modes.end(), mode);
  if (at == modes.end() || *at != mode) modes.insert(at, mode);
}

}  // namespace

void add_enabled(Exits& exits, const std::vector<Choice>& choices, ModeId mode) {
  std::vector<ModeId>& enabled = exits.enabled.emplace_back();
  exits.open.emplace_back();
  for (const Choice& choice : choices) {
    if (choice.faults == 0 && choice.mode != mode && choice.clock.upper == unbounded) include(enabled, choice.mode);
  }
}

void add_open(Exits& exits, const Modes& from, const Modes& to, const Box& bounds, const TimeModel& time) {
  // No period ends as a clock reads 0.
  const bool never = !time.is_dense() &&
                     std::any_of(bounds.begin(), bounds.end(), [](const ClockBound& b) { return b.clock.upper == 0; });
  if (never) return;
  for (std::size_t c = 0; c < from.size(); ++c) {
    const auto bound =
        std::find_if(bounds.begin(), bounds.end(), [c](const ClockBound& b) { return b.component == ComponentId(c); });
    const bool lasts = bound == bounds.end() || bound->clock.upper == unbounded;
    if (from[c] != to[c] && lasts) include(exits.open[c], to[c]);
  }
}

}  // namespace rmpl::verifier
