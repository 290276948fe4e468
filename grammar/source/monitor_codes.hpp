// The codes of monitors and of lint about them, by name. Their entries are part of the registry.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "grammar/source/codes.hpp"

namespace rmpl::grammar {

inline constexpr Code no_monitor{408};
inline constexpr Code monitor_repeated_part{409};
inline constexpr Code monitor_not_observed{410};
inline constexpr Code monitor_limits{411};
inline constexpr Code monitor_overlap{412};
inline constexpr Code channel_without_monitor{413};
inline constexpr Code monitor_gap{570};
inline constexpr Code monitor_hysteresis{571};
inline constexpr Code monitor_value_missing{572};
inline constexpr Code sample_without_reading{573};

std::span<const CodeInfo> monitor_codes();

}  // namespace rmpl::grammar
