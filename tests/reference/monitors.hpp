// The twin of monitors: what they say at a time, from all samples before, by definition.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/monitor.hpp"
#include "automata/state.hpp"

namespace rmpl::reference {

struct ChannelSaid {
  automata::Ticks time;
  std::string channel;
  std::string text;
  std::optional<double> number;
};

/// The readings at `now`, sorted by attribute, where each of the samples, in order of time, came by itself. Cubic.
automata::Observation readings(const std::vector<automata::Monitor>& monitors, const std::vector<ChannelSaid>& samples,
                               automata::Ticks now);

}  // namespace rmpl::reference
